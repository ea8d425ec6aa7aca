// SPDX-License-Identifier: Apache-2.0
// Keys at uneven times, from one to the next of which the body turns by up to 2.4 rad about any axis.

/** Mulberry32: the same numbers from 0 to 1 from the same seed. */
const diceOf = (seed) => () => {
  seed = (seed + 0x6d2b79f5) | 0;
  let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
};

const product = ([a, b, c, d], [e, f, g, h]) => [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];

const unit = (v) => v.map((x) => x / Math.hypot(...v));

/** In the order wxyz. */
export const keysOf = (count, seed) => {
  const dice = diceOf(seed), times = new Float64Array(count), orientations = new Float64Array(4 * count);
  for (let k = 0, time = 0, q = [1, 0, 0, 0]; k < count; ++k) {
    times[k] = time;
    orientations.set(q, 4 * k);
    time += 0.5 + dice();
    const half = 0.05 + 1.15 * dice(), axis = unit([dice() - 0.5, dice() - 0.5, dice() - 0.5]);
    q = unit(product(q, [Math.cos(half), ...axis.map((x) => Math.sin(half) * x)]));
  }
  return { times, orientations, order: 'wxyz' };
};
