// SPDX-License-Identifier: Apache-2.0
// What the page shows: the JSON document of studio/report/README.md, read once.

export interface Path {
  t: number[];
  q: number[]; // w, x, y, z of each
}

export interface Column {
  id: string;
  label: string;
  unit: string;
  explanation: string;
  better: 'less' | 'more' | 'neither';
}

export interface Samples extends Path {
  w: number[];
  a: number[];
  j: number[];
  p: number[];
  error_deg: (number | null)[];
}

export interface Method {
  name: string;
  continuity: string;
  failure: string;
  measures: Record<string, number | null>;
  samples: Samples;
}

export type BodyShape = 'aircraft' | 'box' | 'axes';

export interface Report {
  title: string;
  command: string;
  date: string;
  version: string;
  time_start: string;
  body: BodyShape;
  keys: Path & { p: number[] };
  reference: Path | null;
  columns: Column[];
  sorted_by: string;
  methods: Method[];
}

export const report: Report = JSON.parse(document.getElementById('report-data')!.textContent!);

export const hasSamples = (method: Method) => method.samples.t.length > 1;
export const shownMethods = report.methods.filter(hasSamples);
export const methodNamed = (name: string | null) => shownMethods.find((method) => method.name === name);

const ends = [...shownMethods.map((method) => method.samples.t), report.keys.t].filter((t) => t.length > 0);
export const timeStart = Math.min(...ends.map((t) => t[0]));
export const timeEnd = Math.max(...ends.map((t) => t[t.length - 1]));
