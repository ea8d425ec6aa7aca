// SPDX-License-Identifier: Apache-2.0
// How smooth the curve of A is at keys, in words.
import type { State } from './store';

const rates = ['velocity', 'acceleration', 'jerk'];

/** No rate up to the order jumps. */
export function reachedText(order: number | undefined): string {
  if (order === undefined) return '';
  if (order < 0) return 'orientation jumps';
  return order < rates.length ? `${rates[order]} jumps` : 'smooth';
}

/** The order at each key, where the curve of A is that through these keys. */
export function ordersOf({ curves, document }: Readonly<State>): ArrayLike<number> | null {
  const drawn = curves?.first;
  return drawn && 'orders' in drawn && drawn.orders.length === document.keys.length ? drawn.orders : null;
}

const seen = 2; // a jump of the jerk is not

/** Whether velocity or acceleration jumps. */
export const jumps = (order: number | undefined): boolean => order !== undefined && order < seen;
