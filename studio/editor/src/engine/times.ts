// SPDX-License-Identifier: Apache-2.0
import { difference, numberOf, shortest, sum } from '../document/decimal';

/** Even times [s], both ends among them: those of `orispline sample --count`, which adds to the start the shortest decimal of each offset. */
export function evenTimes(start: number, end: number, count: number): Float64Array {
  if (start === end) return Float64Array.of(start);
  const from = shortest(start), span = numberOf(difference(shortest(end), from));
  return Float64Array.from({ length: count }, (_, k) => {
    if (k === 0) return start;
    if (k === count - 1) return end;
    const offset = (span * k) / (count - 1);
    return start === 0 ? offset : numberOf(sum(from, shortest(offset)));
  });
}

/** The last double before a time. */
export function before(time: number): number {
  const number = Float64Array.of(time || -0), bits = new BigInt64Array(number.buffer);
  bits[0] += time > 0 ? -1n : 1n;
  return number[0];
}

/** Both lists by time. Those of `inner` stand twice, for their two sides, of which `left` has the places of the first. */
export function mergedTimes(even: Float64Array, inner: readonly number[]): { times: Float64Array; left: number[] } {
  const times: number[] = [], left: number[] = [];
  let next = 0;
  for (let k = 0; k <= even.length; ++k) {
    const time = k < even.length ? even[k] : Number.POSITIVE_INFINITY;
    let isInner = false;
    for (; inner[next] <= time; ++next) {
      isInner = inner[next] === time;
      left.push(times.length);
      times.push(inner[next], inner[next]);
    }
    if (!isInner) times.push(time);
  }
  times.pop();
  return { times: Float64Array.from(times), left };
}
