// SPDX-License-Identifier: Apache-2.0
// Curves are made of the keys as their file has them, whose times count from the first key, so that they have the bits of the file's curve.
import { difference, numberOf, shortest } from '../document/decimal';
import { countedFromFirst } from '../document/times';
import type { Key } from '../document/document';

export interface Counted {
  readonly keys: readonly Key[];
  /** A time of the document as one of these keys. */
  counted(time: number): number;
  /** Times of these keys as those of the document; that of a key is its own. */
  given(times: Float64Array): Float64Array;
}

export function countedOf(keys: readonly Key[]): Counted {
  const first = keys[0]?.t ?? 0;
  if (first === 0) return { keys, counted: (time) => time, given: (times) => times };
  const counted = countedFromFirst(keys);
  const own = new Map(counted.map(({ t }, k) => [t, keys[k].t]));
  return {
    keys: counted,
    counted: (time) => numberOf(difference(shortest(time), shortest(first))),
    given: (times) => times.map((time) => own.get(time) ?? first + time),
  };
}
