// SPDX-License-Identifier: Apache-2.0
// Where something happens.
import type { Numbers } from '../data/numbers';
import type { Method } from '../data/report';
import { anglesApart } from './lines';

const rounding = 1e-4; // [deg] or [rad/s], of what is written

/** The time of the largest value; nothing where none is more than rounding. */
function timeOfLargest(t: Numbers, values: Numbers): number | null {
  let largest = -1;
  values.forEach((value, i) => {
    if (value > (largest < 0 ? rounding : values[largest])) largest = i;
  });
  return largest < 0 ? null : t[largest];
}

const nothing = { t: new Float64Array(), values: new Float64Array() };
const speeds = (w: Numbers) => Float64Array.from({ length: w.length / 3 }, (_, i) => Math.hypot(w[3 * i], w[3 * i + 1], w[3 * i + 2]));

/**
 * What is shown at first: where the first method's error is the largest, else where both methods differ most, else where the first one
 * turns fastest. A method with a clock of its own has no time in common with others.
 */
export function startingTime(first: Method | undefined, second: Method | undefined, start: number): number {
  if (!first || first.clock) return start;
  const { t, w, error_t, error_deg } = first.samples;
  const atError = timeOfLargest(error_t.length > 0 ? error_t : t, error_deg);
  if (atError !== null) return atError;
  const apart = second && !second.clock ? anglesApart(first.samples, second.samples) : nothing;
  return timeOfLargest(apart.t, apart.values) ?? timeOfLargest(t, speeds(w)) ?? start;
}
