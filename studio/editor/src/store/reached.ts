// SPDX-License-Identifier: Apache-2.0
// How smooth the curve is at keys, in words.
import type { State } from './store';

/** What the marks of keys mean. */
export const marks: Record<'◆' | '◇', string> = {
  '◆': 'The curve is smooth at the key: neither velocity nor acceleration jumps; the jerk may.',
  '◇': 'Its velocity or acceleration jumps at the key.',
};

const words = ['orientation jumps', 'velocity jumps', 'acceleration jumps', 'smooth, jerk jumps', 'smooth'];

/** No rate up to the order jumps. */
export const reachedText = (order: number | undefined): string => (order === undefined ? '' : words[Math.min(order + 1, words.length - 1)]);

/** The order at each key, where the curve is that through these keys. */
export function ordersOf({ curves, document }: Readonly<State>): ArrayLike<number> | null {
  const drawn = curves?.first;
  return drawn && 'orders' in drawn && drawn.orders.length === document.keys.length ? drawn.orders : null;
}

const smooth = 2; // order: who sees the motion sees no jump of the jerk

/** Whether velocity or acceleration jumps. */
export const jumps = (order: number | undefined): boolean => order !== undefined && order < smooth;
