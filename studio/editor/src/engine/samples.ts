// SPDX-License-Identifier: Apache-2.0
import type { Samples as Rows } from 'orispline/curve';
import type { WholeCurve } from 'orispline/whole_curve';
import type { Samples } from './protocol';
import { before, evenTimes, mergedTimes } from './times';

const none = (): Float64Array => new Float64Array();

const named = ({ times, orientations, angularVelocities, angularAccelerations, angularJerks, positions }: Rows): Omit<Samples, 'orders'> => ({
  t: times, q: orientations, w: angularVelocities ?? none(), a: angularAccelerations ?? none(), j: angularJerks ?? none(), p: positions ?? none(),
});

/** `count` samples at even times, as `orispline sample --count` has them. */
export const evenSamples = (curve: WholeCurve, count: number, rates: 0 | 1 | 2 | 3): Omit<Samples, 'orders'> =>
  named(curve.sample({ times: evenTimes(curve.start, curve.end, count), rates }));

/** Those with all rates, and with both sides of every key between the ends: what bulk sampling has on the left is that of the last double before. */
export function drawnSamples(curve: WholeCurve, keyTimes: readonly number[], count: number): Samples {
  const inner = keyTimes.filter((t) => curve.start < t && t < curve.end);
  const { times, left } = mergedTimes(evenTimes(curve.start, curve.end, count), inner);
  const asked = times.slice();
  for (const k of left) asked[k] = before(times[k]);
  return { ...named(curve.sample({ times: asked, rates: 3 })), t: times, orders: curve.orders() };
}
