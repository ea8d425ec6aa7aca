// SPDX-License-Identifier: Apache-2.0
// What the page shows: the JSON document of studio/report/README.md, read once.

export interface Path {
  t: number[];
  q: (number | null)[]; // w, x, y, z of each; null in a gap
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

type Vectors = (number | null)[]; // null in a gap

export interface Samples extends Path {
  w: Vectors;
  a: Vectors;
  j: Vectors;
  torque: Vectors;
  p: number[];
  error_t: number[]; // empty: t
  error_deg: (number | null)[];
}

export type Keys = Path & { p: number[] };

/** Drawn behind the lines of a plot. */
export interface Band {
  label: string;
  t: number[];
  low: (number | null)[]; // null ends it
  high: (number | null)[];
}

export interface Method {
  name: string;
  continuity: string;
  failure: string;
  measures: Record<string, number | null>;
  samples: Samples;
  keys: Keys | null; // null: those of the report
  bands?: Record<string, Band>; // by the id of the quantity
}

/** Orientations that stand out. */
export interface Marks extends Path {
  label: string;
  error_deg: (number | null)[];
}

export type BodyShape = 'aircraft' | 'box' | 'axes';

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
  key_t: number[]; // [s], of the rotation after
}

/** Whole numbers, in steps. */
export interface Poses {
  t: number[];
  step: number;
  before: number[]; // x, y, z of every joint at the first time; then how far each is from that of the time before
  offset_step: number;
  after: number[]; // x, y, z of every joint at every time, from where it is before
}

/** Of every joint, in steps; empty where all is 0. */
export interface Errors {
  t: number[];
  angle_step: number;
  angle_deg: number[][];
  distance_step: number;
  distance: number[][];
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

/** A skeleton that moves in two ways; lengths have one unit. */
export interface Skeleton {
  before: string; // what the motions are called
  after: string;
  unit: string; // of lengths; empty: not known
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
  notes: string[];
  body: BodyShape;
  keys: Keys;
  reference: Path | null;
  marks: Marks | null;
  limits: Record<string, number>; // by the id of the quantity
  units: Record<string, Unit>; // likewise
  columns: Column[];
  sorted_by: string;
  first: string; // names of the methods that are shown at first
  second: string;
  methods: Method[];
  skeleton?: Skeleton; // instead of methods
}

const noMethods = { time_start: '', body: 'box', keys: { t: [], q: [], p: [] }, reference: null, marks: null, limits: {}, units: {}, columns: [], sorted_by: '', first: '', second: '', methods: [] };
export const report: Report = { ...noMethods, ...JSON.parse(document.getElementById('report-data')!.textContent!) };

/** Methods that were sampled at the same times share them, so that their lines need not be joined. */
const seen = new Map<string, number[]>();
for (const { samples } of report.methods) {
  const key = samples.t.join();
  samples.t = seen.get(key) ?? samples.t;
  seen.set(key, samples.t);
}

export const hasSamples = (method: Method) => method.samples.t.length > 1;
export const shownMethods = report.methods.filter(hasSamples);

/** What is shown until the user chooses: what the report says, else the first of the methods. */
const nameIn = (methods: Method[], name: string) => (methods.find((method) => method.name === name) ?? methods[0])?.name ?? null;
export const firstShown = nameIn(shownMethods, report.first);
export const secondShown = nameIn(
  shownMethods.filter(({ name }) => name !== firstShown),
  report.second,
);
export const methodNamed = (name: string | null) => shownMethods.find((method) => method.name === name);

/** The keys that the curve of a method goes through. */
export const keysOf = (method: Method | undefined) => method?.keys ?? report.keys;

/** A sample that only says that there is nothing between its neighbours. */
export const isGap = ({ q }: Path, i: number) => q[4 * i] === null;

/** All clips of a skeleton: empty in a report of methods. */
export const clips = report.skeleton?.clips ?? [];

const ends = [...shownMethods.map((method) => method.samples.t), report.keys.t, ...clips.map(({ start, end }) => [start, end])].filter((t) => t.length > 0);
export const timeStart = Math.min(...ends.map((t) => t[0]));
export const timeEnd = Math.max(...ends.map((t) => t[t.length - 1]));
