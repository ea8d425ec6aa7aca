// SPDX-License-Identifier: Apache-2.0
// Which column of a table holds what, told by the names in its header as the library tells it, where that is simple: quaternions, and times in
// one column. What is guessed wrong here is found when the text is read back.
import type { Cell, Table } from './table';
import { cellsOf } from './table';

/** A number with a unit: what a cell says, times numerator, over denominator. */
export interface NumberColumn {
  readonly index: number;
  readonly numerator: number;
  readonly denominator: number;
}

export interface Columns {
  readonly width: number; // cells of a row
  readonly time: number;
  readonly q: readonly number[]; // w, x, y, z
  readonly p: readonly NumberColumn[] | null;
  readonly rates: readonly (readonly number[])[]; // those in the body frame and its own units
  readonly header: Header | null; // null: the format has no names
}

interface Header {
  readonly names: readonly string[]; // as they are written
  readonly compared: readonly string[];
}

const timeNames = /^((t|time|timestamp|stamp)(_(s|secs?|seconds|ms|msec|us|usec|ns|nsecs?|nanos|nanosec|nanoseconds))?|secs?|seconds|[mu]sec|nsecs?|nanosec)$/;
const lengths: Record<string, [number, number]> = { '': [1, 1], _m: [1, 1], _mm: [1, 1000], _cm: [1, 100], _km: [1000, 1] };
const placeNames = [['px', 'py', 'pz'], ['tx', 'ty', 'tz'], ['x', 'y', 'z']];
const rateForms = ['w', 'a', 'j'].map((letter, order) => ({ letter, ends: ['', '_body', '_rad_s', '_body_rad_s'].map((end) => (end.endsWith('rad_s') && order > 0 ? `${end}${order + 1}` : end)) }));

/** A unit in brackets as the end of the name: `px [mm]` is `px_mm`. */
function plain(name: string): string {
  const found = /^(.+?) *[([]([^([\])]*)[)\]]$/.exec(name);
  if (!found || /^\d+$/.test(found[2])) return name;
  const unit = found[2].replace(/[µμ]/g, 'u').replace(/°/g, 'deg').replace(/²/g, '2').replace(/³/g, '3').replaceAll('/', '_').replace(/[\^ ]/g, '');
  return unit ? `${found[1]}_${unit}` : found[1];
}

/** Names are compared without case and blanks; those of ROS and PX4 are ours. */
function compared(name: string): string {
  const text = plain(name).replace(/[ \t]/g, '').toLowerCase().replace(/[./]/g, '_');
  const part = text.replace(/^(_|pose_)+/, '');
  const theirs = /^(?:(orientation|q)_([wxyz])|(position)_([xyz])|q\[([0-3])\])(?=_|$)(.*)$/.exec(part);
  if (!theirs) return text;
  const [, orientation, component, position, axis, index, rest] = theirs;
  return (orientation ? `q${component}` : position ? `p${axis}` : `q${'wxyz'[Number(index)]}`) + rest;
}

const headerOf = (cells: readonly Cell[]): Header => {
  const names = cells.map(({ content }) => content);
  return { names, compared: names.map(compared) };
};

/** The column of a name: as it is written, else alike; -1 where there is none, or several. */
export function columnNamed({ names, compared: others }: Header, name: string): number {
  if (names.includes(name)) return names.indexOf(name);
  const alike = compared(name);
  return others.indexOf(alike) === others.lastIndexOf(alike) ? others.indexOf(alike) : -1;
}

function timeColumn(header: Header): number {
  if (header.names.includes('t')) return header.names.indexOf('t');
  const found = header.compared.flatMap((name, i) => (timeNames.test(name) ? [i] : []));
  return found.length === 1 ? found[0] : -1;
}

function placeColumns(header: Header): NumberColumn[] | null {
  for (const names of placeNames) {
    const columns = names.flatMap((name) =>
      Object.entries(lengths).flatMap(([unit, [numerator, denominator]]) => {
        const index = columnNamed(header, name + unit);
        return index < 0 ? [] : [{ index, numerator, denominator }];
      }),
    );
    if (columns.length === 3) return columns;
    if (columns.length > 0 && names === placeNames[0]) return null;
  }
  return null;
}

function rateColumns(header: Header): number[][] {
  const found = rateForms.map(({ letter, ends }) => ends.map((end) => [...'xyz'].map((axis) => columnNamed(header, letter + axis + end))).find((columns) => columns.every((index) => index >= 0)));
  const missing = found.indexOf(undefined);
  return found.slice(0, missing < 0 ? 3 : missing) as number[][];
}

const tum: Columns = {
  width: 8,
  time: 0,
  q: [7, 4, 5, 6],
  p: [1, 2, 3].map((index) => ({ index, numerator: 1, denominator: 1 })),
  rates: [],
  header: null,
};

/** Null where it is not simple. */
export function columnsOf({ lines, rows, delimiter }: Table): Columns | null {
  const cells = cellsOf(lines[rows[0]].text, delimiter);
  if (!cells) return null;
  while (cells.at(-1)?.content === '') cells.pop();
  const first = cells.find(({ content }) => content !== '')?.content;
  if (first === undefined) return null;
  if (/^[-+.\d]/.test(first)) return cells.length === 8 && (delimiter === ' ' || delimiter === '\t') ? tum : null;
  const header = headerOf(cells);
  const time = timeColumn(header);
  const q = [...'wxyz'].map((component) => columnNamed(header, `q${component}`));
  if (time < 0 || q.some((index) => index < 0)) return null;
  return { width: cells.length, time, q, p: placeColumns(header), rates: rateColumns(header), header };
}
