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
}
/** A curve that plays the content of a .json, parsed, or the bytes of a .bin. It gives x, y, z, w. */
export declare const player: (file: BakedFile | ArrayBuffer | ArrayBufferView) => Playable;
