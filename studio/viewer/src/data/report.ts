// SPDX-License-Identifier: Apache-2.0
// What a viewer shows. Lists of vectors and quaternions are flat; NaN stands in a gap, and for what is not known.
import type { Numbers } from './numbers';

export interface Path {
  t: Numbers; // [s]
  q: Numbers; // w, x, y, z of each, body to world
}

export interface Column {
  id: string;
  label: string;
  unit: string;
  explanation: string;
  better: 'less' | 'more' | 'neither';
  is_time: boolean; // a moment of the motion [s]
  rounding: number; // smaller values are 0
}

/** Another unit than the page's own. */
export interface Unit {
  unit: string;
  size: number; // in the page's own
}

/** Rates are in the body frame. */
export interface Samples extends Path {
  w: Numbers; // [rad/s]
  a: Numbers; // [rad/s²]
  j: Numbers; // [rad/s³]
  torque: Numbers; // [N m], or empty
  p: Numbers; // [m], or empty
  error_t: Numbers; // empty: t
  error_deg: Numbers; // or empty
  straight: boolean; // orientations go the shortest way between samples, since their rates are noise
  exactness_deg: number | null; // how far the cubic between the samples is from the curve at most; null: not known
}

export type Keys = Path & { p: Numbers };

/** Drawn behind the lines of a plot. */
export interface Band {
  label: string;
  t: Numbers;
  low: Numbers; // NaN ends it
  high: Numbers;
}

/** The motion's own time at times of the page; linear between. */
export interface Clock {
  t: Numbers;
  own: Numbers;
}

export interface Method {
  name: string;
  continuity: string;
  failure: string;
  measures: Record<string, number | null>;
  samples: Samples;
  keys: Keys; // that the curve goes through
  bands: Record<string, Band>; // by the id of the quantity
  clock: Clock | null; // null: that of the page
}

/** Orientations that stand out. */
export interface Marks extends Path {
  label: string;
  error_deg: Numbers;
}

export type BodyShape = 'aircraft' | 'box' | 'axes' | 'camera';

/** How far a joint is off at most, and when [s]. */
export type Largest = [value: number, time: number];
export type KeyCounts = [before: number, after: number];

export interface Joint {
  name: string;
  parent: number | null; // its index
  is_compared: boolean; // else it is in the motion before only
}

export interface ClipJoint {
  angle_deg: Largest;
  distance: Largest;
  keys: KeyCounts; // of its rotation
  key_t: Numbers; // [s], of the rotation after
}

/** Whole numbers, in steps. */
export interface Poses {
  t: Numbers;
  step: number;
  before: Numbers; // x, y, z of every joint at the first time; then how far each is from that of the time before
  offset_step: number;
  after: Numbers; // x, y, z of every joint at every time, from where it is before; empty: there is only one motion
}

/** Of every joint, in steps; empty where all is 0. */
export interface Errors {
  t: Numbers;
  angle_step: number;
  angle_deg: Numbers[];
  distance_step: number;
  distance: Numbers[];
}

export interface Clip {
  name: string;
  start: number;
  end: number;
  rotation_keys: KeyCounts;
  translation_keys: KeyCounts;
  poses: Poses;
  errors: Errors;
  joints: ClipJoint[];
}

/** A skeleton that moves in two ways, or in one; lengths have one unit. */
export interface Skeleton {
  before: string; // what the motions are called
  after: string; // empty: there is only the one before, and errors are from where a clip begins
  unit: string; // of lengths
  shell: number;
  up: 'y' | 'z';
  angle_limit: number | null; // [deg]
  distance_limit: number | null;
  joints: Joint[];
  clips: Clip[];
}

export interface Report {
  title: string;
  command: string;
  date: string;
  version: string;
  time_start: string;
  warnings: string[]; // sentences that stand apart from the notes
  notes: string[];
  body: BodyShape;
  keys: Keys;
  reference: Path | null;
  marks: Marks | null;
  limits: Record<string, number>; // by the id of the quantity
  units: Record<string, Unit>; // by the id of the quantity
  columns: Column[];
  sorted_by: string;
  first: string; // names of the methods that are shown at first
  second: string;
  methods: Method[];
  skeleton: Skeleton | null; // instead of methods
}

const none = new Float64Array();

/** With nothing in it but what is given. */
export const reportOf = (given: Partial<Report>): Report => ({
  title: '',
  command: '',
  date: '',
  version: '',
  time_start: '',
  warnings: [],
  notes: [],
  body: 'box',
  keys: { t: none, q: none, p: none },
  reference: null,
  marks: null,
  limits: {},
  units: {},
  columns: [],
  sorted_by: '',
  first: '',
  second: '',
  methods: [],
  skeleton: null,
  ...given,
});

export const isAlone = ({ after }: Skeleton) => after === '';
export const hasSamples = ({ samples }: Method) => samples.t.length > 1;
export const hasPositions = ({ samples, keys }: Method) => samples.p.length > 0 && keys.p.length > 0;

/** A sample that only says that there is nothing between its neighbours. */
export const isGap = ({ q }: Path, i: number) => Number.isNaN(q[4 * i]);
