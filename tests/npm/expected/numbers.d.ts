import { OrisplineError } from './errors.js';
/** What WebAssembly can address [bytes]. */
export declare const mostMemory: number;
/** That so many bytes cannot be had, of the memory of the library or of JavaScript. */
export declare const noMemory: (bytes: number) => OrisplineError;
/** Told before anything is done: so many numbers that WebAssembly could not hold them. */
export declare const checkRoom: (count: number) => void;
/** Room for so many numbers. */
export declare const roomFor: (count: number) => Float64Array;
/** The numbers of an argument as doubles of our own, so that nothing but numbers enters the library, and no code of the caller runs meanwhile. */
export declare const numbersOf: (option: string, given: ArrayLike<number> | undefined) => Float64Array;
