// SPDX-License-Identifier: Apache-2.0
import { OrisplineError, badArgument } from './errors.js';

/** What WebAssembly can address [bytes]. */
export const mostMemory = 2 ** 32;

/** That so many bytes cannot be had, of the memory of the library or of JavaScript. */
export const noMemory = (bytes: number): OrisplineError =>
  new OrisplineError('no_memory', `found no memory for ${bytes} bytes more, wanted fewer keys or samples`);

/** Told before anything is done: so many numbers that WebAssembly could not hold them. */
export const checkRoom = (count: number): void => {
  if (8 * count >= mostMemory) throw noMemory(8 * count);
};

const made = (option: string, count: number, of: ArrayLike<number> | number): Float64Array => {
  checkRoom(count);
  try {
    return new Float64Array(of as number);
  } catch (reason) {
    throw reason instanceof RangeError ? noMemory(8 * count) : badArgument(option, `found something else (${(reason as Error).message}), wanted numbers`);
  }
};

/** Room for so many numbers. */
export const roomFor = (count: number): Float64Array => made('count', count, count);

/** The numbers of an argument as doubles of our own, so that nothing but numbers enters the library, and no code of the caller runs meanwhile. */
export const numbersOf = (option: string, given: ArrayLike<number> | undefined): Float64Array => {
  if (typeof given !== 'object' || !(given?.length >= 0)) throw badArgument(option, 'found none, wanted an array of numbers');
  return made(option, given.length, given);
};
