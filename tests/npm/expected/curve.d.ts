/// <reference lib="esnext.disposable" preserve="true" />
import type { Address, Engine } from './engine.js';
import { type KeyData, type Order } from './keys.js';
import { type Settings } from './method.js';
import type { Numbers, Playable } from './playable.js';
/** How the body moves at one time. */
export interface Motion {
    /** In the order of the keys. */
    orientation: number[];
    /** [rad/s], body. */
    angularVelocity: number[];
    /** [rad/s²], body. */
    angularAcceleration: number[];
    /** [rad/s³], body. */
    angularJerk: number[];
    /** [m], world, where the keys have positions, as is all that follows. */
    position?: number[];
    /** [m/s]. */
    velocity?: number[];
    /** [m/s²]. */
    acceleration?: number[];
    /** [m/s³]. */
    jerk?: number[];
}
/** Which samples: at given times, or `count` even ones. Without `count` those up to the end. */
export interface SampleOptions {
    times?: ArrayLike<number>;
    /** [s]; the start of the curve. */
    start?: number;
    /** [s]. */
    step?: number;
    count?: number;
    /** Up to which order rates are wanted: 0 none, 1 angular velocities, 2 and accelerations, 3 and jerks. */
    rates?: 0 | 1 | 2 | 3;
}
/** Samples row after row. */
export interface Samples {
    /** [s]. */
    times: Float64Array;
    /** In the order of the keys. */
    orientations: Float64Array;
    /** [rad/s], body. */
    angularVelocities?: Float64Array;
    /** [rad/s²], body. */
    angularAccelerations?: Float64Array;
    /** [rad/s³], body. */
    angularJerks?: Float64Array;
    /** [m], world, where the keys have positions. */
    positions?: Float64Array;
}
/** The rates of a sample, by their order. */
declare const rateNames: readonly ['angularVelocities', 'angularAccelerations', 'angularJerks'];
/** Those that are asked for. */
export declare const ratesOf: (options: SampleOptions) => (typeof rateNames)[number][];
/** The times that are asked for. */
export declare const timesOf: (curve: Playable, options: SampleOptions) => Float64Array;
/** A curve through keys. It is freed where it is disposed of, or some time after it was forgotten. */
export declare class Curve implements Playable {
    readonly start: number;
    readonly end: number;
    readonly order: Order;
    readonly hasPositions: boolean;
    protected readonly engine: Engine;
    protected readonly keyCount: number;
    private address;
    protected readonly orderNumber: number;
    private readonly forgotten;
    /** Of an `Orispline`, by its `curve`. */
    constructor(engine: Engine, forgotten: FinalizationRegistry<Address>, method: string, data: KeyData, settings: Settings);
    /** Writes the orientation at a time [s] into `target` and returns it. It allocates nothing where there is a target. */
    at<Target extends Numbers = number[]>(time: number, target?: Target): Target;
    /** Writes the position [m] in the same way, where the keys have positions. */
    positionAt<Target extends Numbers = number[]>(time: number, target?: Target): Target;
    /** The motion at a time [s]; at a key where rates jump that of the segment behind it, or of the one before it. */
    motion(time: number, side?: 'right' | 'left'): Motion;
    /** Many samples, one after another. */
    sample(options: SampleOptions): Samples;
    /** Frees its memory at once. It can be done twice. */
    dispose(): void;
    /** The same at the end of a block: `using curve = ori.curve(…)`. */
    [Symbol.dispose](): void;
    protected get handle(): Address;
    private told;
}
export {};
