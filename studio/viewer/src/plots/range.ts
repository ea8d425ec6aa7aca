// SPDX-License-Identifier: Apache-2.0
// How high a plot is.
import uPlot from 'uplot';
import type { Course, Line } from '../quantities/quantity';

const flat = 4; // so many times as large a line is cut that yields
const rounding = 1e-12; // of 1

export interface Reach {
  low: number;
  high: number;
}

/** From its least value to its largest one, of a stretch of time. */
function reachOf({ t, values }: Course, [from, to]: readonly [number, number]): Reach {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < t.length; ++i) {
    if (t[i] < from || t[i] > to) continue;
    if (values[i] < low) low = values[i];
    if (values[i] > high) high = values[i];
  }
  return { low, high };
}

const both = (one: Reach, other: Reach): Reach => ({ low: Math.min(one.low, other.low), high: Math.max(one.high, other.high) });
const nothing: Reach = { low: Infinity, high: -Infinity };

export interface Cut {
  label: string;
  largest: number;
}

/** What a plot has to show of its lines, and which of them go on beyond it. */
export function shownOf(lines: Line[], window: readonly [number, number], least: number): { reach: Reach; cuts: Cut[] } {
  const reaches = lines.map((line) => ({ line, reach: reachOf(line.course(), window) }));
  const leading = reaches.filter(({ line }) => !line.yields).reduce((sum, { reach }) => both(sum, reach), { ...nothing, high: least > 0 ? least : -Infinity });
  const isCut = ({ line, reach }: { line: Line; reach: Reach }) => !!line.yields && leading.high > 0 && reach.high > flat * leading.high;
  const reach = reaches.filter((one) => !isCut(one)).reduce((sum, one) => both(sum, one.reach), leading);
  return { reach, cuts: reaches.filter(isCut).map(({ line, reach: { high } }) => ({ label: line.label, largest: high })) };
}

/** With 0, and a range where all is 0 too. */
export const rangeOf = ({ low, high }: Reach): uPlot.Range.MinMax =>
  uPlot.rangeNum(low < -rounding ? low : 0, high > rounding || low < -rounding ? Math.max(high, 0) : 1, 0.06, true);
