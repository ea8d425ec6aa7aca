import type { Address, Engine } from './engine.js';
/** The order of the four numbers of a quaternion. It is never guessed. */
export type Order = 'wxyz' | 'xyzw';
/** Orientations at times, body to world, and what may stand beside them. All numbers lie row after row. */
export interface KeyData {
    /** [s], increasing. */
    times: ArrayLike<number>;
    /** Four numbers a key, norms within 1e-3 of 1. */
    orientations: ArrayLike<number>;
    /** Of the orientations, and of all that is made of these keys. */
    order: Order;
    /** Three numbers a key [m], world. */
    positions?: ArrayLike<number>;
    /** [rad/s], body; a row of NaN is left to the method. */
    angularVelocities?: ArrayLike<number>;
    /** [rad/s²], body; a row of NaN is left to the method. */
    angularAccelerations?: ArrayLike<number>;
    /** [rad/s³], body; a row of NaN is left to the method. */
    angularJerks?: ArrayLike<number>;
    /** Whether to go from key to key the short way round, or as the signs of the quaternions say. */
    signs?: 'shortest' | 'as-given';
}
/** What one of several words stands for. */
export declare const chosen: <Word extends string>(option: string, word: Word, words: Record<Word, number>) => number;
export declare const orderOf: (order: Order) => number;
/** Keys that are there at all. */
export declare const checkedKeys: (keys: KeyData) => KeyData;
/** Keys in the memory of the library, for the time of some work. */
export declare const withKeys: <Result>(engine: Engine, data: KeyData, work: (keys: Address) => Result) => Result;
