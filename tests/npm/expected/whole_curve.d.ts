import { Curve, type SampleOptions, type Samples } from './curve.js';
import type { BakedFile } from './player.js';
/** How far a rate jumps at the keys. */
export interface Jump {
    /** In the unit of the rate. */
    largest: number;
    /** To the largest rate of the curve; 0 where every jump is rounding. */
    relative: number;
    /** Where. */
    key: number;
}
/** Which rates are continuous at the keys. */
export interface Continuity {
    /** No rate up to this order jumps: 0 to 3; -1 where the orientation itself jumps. */
    order: number;
    /** [rad/s]. */
    angularVelocity: Jump;
    /** [rad/s²]. */
    angularAcceleration: Jump;
    /** [rad/s³]. */
    angularJerk: Jump;
}
/** The largest value of a rate that was found, and where [s]. It is nowhere above `bound`, which is absent where no bound is known. */
export interface Peak {
    value: number;
    time: number;
    bound?: number;
}
export interface Peaks {
    /** [rad/s]. */
    angularVelocity: Peak;
    /** [rad/s²]. */
    angularAcceleration: Peak;
    /** [N m], with an inertia. */
    torque?: Peak;
}
/** A curve by any method. */
export declare class WholeCurve extends Curve {
    /** Samples in bulk, which is many times faster than one after another. */
    sample(options: SampleOptions): Samples;
    /** Which rates are continuous at the keys, and how far the others jump. */
    continuity(): Continuity;
    /** The order that is reached at each key: 3 at the ends, but for those of a loop; -1 where the orientation jumps before the next key. */
    orders(): Int8Array;
    /** The largest rates that were found; with `inertia`, the nine numbers of a symmetric matrix [kg m²], the torque too. */
    peaks(options?: {
        inertia?: ArrayLike<number>;
    }): Peaks;
    /** What `orispline/player` plays: the .json that `orispline bake` writes, with the times of the keys. The tolerances are in rad, and in m for positions. */
    bake(options: {
        tolerance: number;
        positionTolerance?: number;
    }): BakedFile;
    /** The text of its method, with its settings. */
    get method(): string;
    private fill;
}
