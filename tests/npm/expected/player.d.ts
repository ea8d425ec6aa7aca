import type { Numbers, Playable } from './playable.js';
export type { Numbers, Playable };
/** The content of a .json that `orispline bake` wrote. */
export interface BakedFile {
    orispline: string;
    version: number;
    /** Of the components: `xyzw`. */
    order: string;
    /** The time that the ends count from [s]. */
    epoch: number;
    /** From the curve, as it was found [rad]. */
    largest_difference: number;
    /** Of the pieces [s]. */
    ends: number[];
    /** Each has six coefficients of x, of y, of z and of w. */
    pieces: number[][];
    /** From the path, as it was found [m]; this and what follows stand in version 2, which has positions. */
    largest_position_difference?: number;
    /** Of the pieces of positions [s]. */
    position_ends?: number[];
    /** Each has six coefficients of x, of y and of z. */
    position_pieces?: number[][];
}
/** A baked curve that plays. */
export interface Player extends Playable {
    /** Whether the file has positions. */
    readonly hasPositions: boolean;
    /** Writes the position [m] at a time [s] into `target` and returns it; outside it is that of the end, of NaN it is NaN. */
    positionAt<Target extends Numbers = number[]>(time: number, target?: Target): Target;
}
/** A curve that plays the content of a .json, parsed, or the bytes of a .bin. It gives x, y, z, w. */
export declare const player: (file: BakedFile | ArrayBuffer | ArrayBufferView) => Player;
