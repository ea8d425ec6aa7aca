// SPDX-License-Identifier: Apache-2.0
// What a plot shows: lines over time, with what belongs to them.
import type { Numbers } from '../data/numbers';
import type { Band } from '../data/report';
import type { Colours } from '../look/theme';
import { fraction, spanAt } from '../motion/orientation';
import type { State } from '../store/store';

/** What a line goes through. */
export interface Course {
  t: Numbers; // a time that stands twice is a jump
  values: Numbers; // NaN breaks the line
}

export interface Line {
  label: string;
  colour: string;
  width: number;
  dashes?: number[];
  yields?: boolean; // is cut where it would make the others flat
  course: () => Course; // is asked for when the line is drawn
  valueAt: (time: number) => number; // NaN where there is nothing
}

/** Points that stand out. */
export interface Points extends Course {
  label: string;
}

/** Stretches of time, and moments. */
export interface Flags {
  spans: [from: number, to: number][];
  times: number[];
}

/** A band in the colour of its method. */
export interface PlacedBand extends Band {
  place: 'first' | 'second';
}

export interface Quantity {
  id: string;
  title: string;
  unit: string;
  limit?: number; // in that unit
  limitLabel?: string;
  least?: number; // the plot goes up to it at least: what is much smaller is the drawing's own
  keys: (state: State) => Numbers; // times that are marked
  lines: (state: State, colours: Colours) => Line[];
  marks?: Points;
  band?: (state: State) => PlacedBand | undefined;
  flags?: () => Flags; // what stands out in time; as it is when the plot is drawn
  text?: (value: number, state: State) => string; // how its values are written; else with four digits
}

/** On the line, at its ends beyond them; after a jump. */
export function onCourse({ t, values }: Course, time: number): number {
  if (t.length === 0) return NaN;
  const i = spanAt(t, time);
  const u = t.length > 1 ? fraction(t, i, time) : 0;
  return u === 0 || u === 1 ? values[i + u] : (1 - u) * values[i] + u * values[i + 1];
}

/** What a line has that is drawn straight between its values. */
export const straight = (course: () => Course): Pick<Line, 'course' | 'valueAt'> => ({ course, valueAt: (time) => onCourse(course(), time) });

/** Broken where an interval is so many times as long as half of them are: nothing was measured there. */
export function brokenAfter(many: number, { t, values }: Course): Course {
  const steps = Float64Array.from({ length: Math.max(t.length - 1, 0) }, (_, i) => t[i + 1] - t[i]);
  const longest = many * steps.slice().sort()[steps.length >> 1];
  const shown: [number, number][] = [];
  for (let i = 0; i < values.length; ++i) {
    shown.push([t[i], values[i]]);
    if (longest > 0 && steps[i] > longest) shown.push([t[i] + steps[i] / 2, NaN]);
  }
  return { t: Float64Array.from(shown, ([time]) => time), values: Float64Array.from(shown, ([, value]) => value) };
}
