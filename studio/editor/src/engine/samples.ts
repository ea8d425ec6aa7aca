// SPDX-License-Identifier: Apache-2.0
import type { Samples as Rows } from 'orispline/curve';
import type { WholeCurve } from 'orispline/whole_curve';
import type { Samples } from './protocol';
import { remembering } from './same';
import { before, evenTimes, mergedTimes } from './times';

const none = (): Float64Array => new Float64Array();

const named = ({ times, orientations, angularVelocities, angularAccelerations, angularJerks, positions }: Rows): Omit<Samples, 'orders'> => ({
  t: times, q: orientations, w: angularVelocities ?? none(), a: angularAccelerations ?? none(), j: angularJerks ?? none(), p: positions ?? none(),
});

/** `count` samples at even times, as `orispline sample --count` has them. */
export const evenSamples = (curve: WholeCurve, count: number, rates: 0 | 1 | 2 | 3): Omit<Samples, 'orders'> =>
  named(curve.sample({ times: evenTimes(curve.start, curve.end, count), rates }));

const evenTimesAgain = remembering(evenTimes);

/** The times that are drawn, and those that are asked for: what bulk sampling has on the left of a key is that of the last double before. */
const drawnTimes = remembering((start: number, end: number, count: number, keyTimes: ArrayLike<number>) => {
  const inner = Array.from(keyTimes).filter((t) => start < t && t < end);
  const { times, left } = mergedTimes(evenTimesAgain(start, end, count), inner);
  const asked = times.slice();
  for (const k of left) asked[k] = before(times[k]);
  return { times, asked };
});

/** Those with all rates, and with both sides of every key between the ends. */
export function drawnSamples(curve: WholeCurve, keyTimes: ArrayLike<number>, count: number): Samples {
  const { times, asked } = drawnTimes(curve.start, curve.end, count, keyTimes);
  return { ...named(curve.sample({ times: asked, rates: 3 })), t: times.slice(), orders: curve.orders() };
}
