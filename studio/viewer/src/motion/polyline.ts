// SPDX-License-Identifier: Apache-2.0
// Polylines with so many points that their chords are near to what they stand for.
import type { Numbers } from '../data/numbers';

/** Values over times; NaN in a gap, and a time that stands twice is a jump. */
export interface Polyline {
  t: Float64Array;
  values: Float64Array; // of each time as many as the piece has
}

/** What is drawn within one interval, at any time of it. */
export type Piece = (t: number) => readonly number[];

const seen = 0.75; // of how far a kink is from the chord: so much of it at least is seen at one of the quarters
const mostHalvings = 20; // of an interval: an angle has a cusp where it is 0 or 180 degrees

/** How far a value is from the chord between two others, at a part of the way. */
function offChord(from: readonly number[], to: readonly number[], part: number, value: readonly number[]): number {
  let sum = 0;
  for (let k = 0; k < value.length; ++k) sum += ((1 - part) * from[k] + part * to[k] - value[k]) ** 2;
  return Math.sqrt(sum);
}

/** Over the intervals between the times, which do not decrease; where an interval has no piece, the line is broken. */
export function polyline(times: Numbers, pieceOf: (interval: number) => Piece | null, tolerance: number): Polyline {
  const t: number[] = [];
  const values: number[] = [];
  let last: readonly number[] = [];
  const push = (time: number, value: readonly number[]) => {
    t.push(time);
    for (let k = 0; k < value.length; ++k) values.push(value[k]);
    last = value;
  };

  /** From a, which is in the line, to b: halved until the quarters are near to the chord. */
  const reach = (piece: Piece, a: number, atA: readonly number[], b: number, atB: readonly number[], middle: readonly number[], halvings: number) => {
    const first = piece(a + 0.25 * (b - a)), third = piece(a + 0.75 * (b - a));
    const off = Math.max(offChord(atA, atB, 0.25, first), offChord(atA, atB, 0.5, middle), offChord(atA, atB, 0.75, third));
    if (off <= seen * tolerance || halvings === 0) return push(b, atB);
    const half = a + (b - a) / 2;
    reach(piece, a, atA, half, middle, first, halvings - 1);
    reach(piece, half, middle, b, atB, third, halvings - 1);
  };

  for (let i = 0; i + 1 < times.length; ++i) {
    const [a, b] = [times[i], times[i + 1]];
    if (!(b > a)) continue;
    const piece = pieceOf(i);
    if (!piece) {
      if (last.length > 0) push((a + b) / 2, last.map(() => NaN));
      continue;
    }
    const [atA, middle, atB] = [piece(a), piece(a + (b - a) / 2), piece(b)];
    const goesOn = t.at(-1) === a && offChord(last, last, 0, atA) < tolerance / 100;
    if (!goesOn) push(a, atA);
    reach(piece, a, atA, b, atB, middle, mostHalvings);
  }
  return { t: Float64Array.from(t), values: Float64Array.from(values) };
}
