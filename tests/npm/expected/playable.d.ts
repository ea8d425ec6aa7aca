/** Where the four numbers of a quaternion go: an array, or what is indexed like one. */
export interface Numbers {
    [index: number]: number;
}
/** What gives an orientation at every time: a curve, or one that was baked. */
export interface Playable {
    /** The time of the first key [s]. */
    readonly start: number;
    /** The time of the last one [s]. */
    readonly end: number;
    /** Writes the orientation at a time [s] into `target` and returns it; outside it is that of the end, of NaN it is NaN. */
    at<Target extends Numbers = number[]>(time: number, target?: Target): Target;
}
