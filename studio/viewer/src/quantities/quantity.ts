// SPDX-License-Identifier: Apache-2.0
// What a plot shows: lines over time, with what belongs to them.
import type { Numbers } from '../data/numbers';
import type { Band } from '../data/report';
import type { Colours } from '../look/theme';
import type { State } from '../store/store';

export interface Line {
  label: string;
  colour: string;
  width: number;
  dashes?: number[];
  yields?: boolean; // is cut where it would make the others flat
  t: Numbers; // a time that stands twice is a jump
  values: Numbers; // NaN breaks the line
}

/** Points that stand out. */
export interface Points {
  label: string;
  t: Numbers;
  values: Numbers;
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
  keys: (state: State) => Numbers; // times that are marked
  lines: (state: State, colours: Colours) => Line[];
  marks?: Points;
  band?: (state: State) => PlacedBand | undefined;
  text?: (value: number, state: State) => string; // how its values are written; else with four digits
}
