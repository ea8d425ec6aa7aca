import type { Settings } from './method.js';
import type { Orispline } from './orispline.js';
import type { Numbers, Playable } from './playable.js';
/** What an AnimationMixer asks of an interpolant. */
export interface Interpolant {
    parameterPositions: ArrayLike<number>;
    sampleValues: ArrayLike<number>;
    valueSize: number;
    resultBuffer: Numbers;
    settings: unknown;
    evaluate(time: number): Numbers;
}
/** A QuaternionKeyframeTrack or VectorKeyframeTrack. */
export interface Track {
    name: string;
    times: ArrayLike<number>;
    values: ArrayLike<number>;
    ValueTypeName: string;
    createInterpolant?: unknown;
    getInterpolation?(): unknown;
    clone?(): unknown;
}
/**
 * Lets a quaternion or vector track move along the curve of a method through its keys, exactly, also where it is cloned. What is wrong with the keys is
 * told at once.
 *
 * `toJSON` and GLTFExporter do not know the curve: they write the keys, between which others then go by slerp. A
 * warning says so, once. To write it, bake it.
 */
export declare const animate: <Kind extends Track>(ori: Orispline, track: Kind, method?: string, settings?: Settings) => Kind;
/**
 * The times and values of a linear track, which goes by slerp, within `tolerance` [rad] of a curve, with the fewest keys:
 * `new QuaternionKeyframeTrack(name, ...bake(curve, { tolerance: 1e-3 }))`. The curve gives x, y, z, w.
 */
export declare const bake: (curve: Playable & {
    order?: string;
}, options: {
    tolerance: number;
}) => [times: Float32Array, values: Float32Array];
