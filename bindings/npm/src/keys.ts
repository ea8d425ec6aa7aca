// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { badArgument, shown } from './errors.js';
import { numbersOf } from './numbers.js';

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

const orders: Record<Order, number> = { wxyz: 1, xyzw: 2 };
const signs = { shortest: 0, 'as-given': 1 };
const columns = { positions: 'positions', angularVelocities: 'angular_velocities', angularAccelerations: 'angular_accelerations', angularJerks: 'angular_jerks' } as const;

/** What one of several words stands for. */
export const chosen = <Word extends string>(option: string, word: Word, words: Record<Word, number>): number => {
  if (typeof word !== 'string' || !Object.hasOwn(words, word)) throw badArgument(option, `found ${shown(word)}, wanted '${Object.keys(words).join("' or '")}'`);
  return words[word];
};

export const orderOf = (order: Order): number => chosen('order', order, orders);

/** Keys that are there at all. */
export const checkedKeys = (keys: KeyData): KeyData => {
  if (typeof keys !== 'object' || !keys) throw badArgument('keys', `found ${shown(keys)}, wanted { times, orientations, order }`);
  return keys;
};

const rowsOf = (option: string, numbers: ArrayLike<number> | undefined, perKey: number, keys: number): Float64Array => {
  if (numbers?.length !== perKey * keys)
    throw badArgument(option, `found ${numbers?.length ?? 'no'} numbers, wanted ${perKey * keys}, ${perKey} for each of ${keys} times`);
  return numbersOf(option, numbers);
};

/** Keys in the memory of the library, for the time of some work. */
export const withKeys = <Result>(engine: Engine, data: KeyData, work: (keys: Address) => Result): Result => {
  const order = orderOf(data.order), times = numbersOf('times', data.times), count = times.length;
  const orientations = rowsOf('orientations', data.orientations, 4, count);
  const given = Object.entries(columns).flatMap(([option, name]) => {
    const numbers = data[option as keyof typeof columns];
    return numbers === undefined ? [] : [{ name, numbers: rowsOf(option, numbers, 3, count) }];
  });
  /** Puts the columns into memory one by one, so that each is freed again. */
  const withColumns = (k: number, rows: number[]): Result => {
    if (k < given.length)
      return engine.withText(given[k].name, (name) =>
        engine.withNumbers(given[k].numbers, (numbers) => withColumns(k + 1, [...rows, name, numbers, 3 * count])));
    return engine.withWords(rows, (table) => engine.withNumbers(times, (timesAt) => engine.withNumbers(orientations, (orientationsAt) => {
      const keys = engine.made('orispline_keys_make', timesAt, orientationsAt, count, order, chosen('signs', data.signs ?? 'shortest', signs), table, given.length);
      try {
        return work(keys);
      } finally {
        engine.free('orispline_keys_free', keys);
      }
    })));
  };
  return withColumns(0, []);
};
