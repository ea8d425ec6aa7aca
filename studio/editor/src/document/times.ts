// SPDX-License-Identifier: Apache-2.0
// Times of keys as a file of them has them: the library counts from the first key on.
import { difference, numberOf, shortest } from './decimal';
import type { Key } from './document';

/** Keys whose times count from the first one: the doubles that the library reads out of the file in which these keys are saved. */
export function countedFromFirst(keys: readonly Key[]): readonly Key[] {
  if (keys.length === 0 || Object.is(keys[0].t, 0)) return keys;
  const first = shortest(keys[0].t);
  return keys.map((key) => ({ ...key, t: numberOf(difference(shortest(key.t), first)) }));
}
