// SPDX-License-Identifier: Apache-2.0
// Which column of a table holds what, told by the names in its header as the library tells it, where that is simple: one form of orientations,
// and times in one column. What is guessed wrong here is found when the text is read back.
import type { AngleUnit, Form } from '../document/form';
import type { Reading } from '../document/reading';
import { columnNamed, columnWithUnit, headerOf, unitOf, type Header } from './names';
import { cellsOf, tableOf, type Cell, type Table } from './table';

/** A number with a unit: what a cell says, times numerator, over denominator. */
export interface NumberColumn {
  readonly index: number;
  readonly numerator: number;
  readonly denominator: number;
}

export interface Columns {
  readonly width: number; // cells of a row
  readonly time: number;
  readonly form: Form | null; // null: unit quaternions, w, x, y, z
  readonly orientation: readonly number[];
  readonly p: readonly NumberColumn[] | null;
  readonly rates: readonly (readonly number[])[]; // those in the body frame and its own units
  readonly header: Header | null; // null: no line has names
  readonly headerRow: number | null; // the first line that has cells, where that has the names
}

const timeNames = /^((t|time|timestamp|stamp)(_(s|secs?|seconds|ms|msec|us|usec|ns|nsecs?|nanos|nanosec|nanoseconds))?|secs?|seconds|[mu]sec|nsecs?|nanosec)$/;
const lengths: Record<string, [number, number]> = { '': [1, 1], _m: [1, 1], _mm: [1, 1000], _cm: [1, 100], _km: [1000, 1] };
const placeNames = [['px', 'py', 'pz'], ['tx', 'ty', 'tz'], ['x', 'y', 'z']];
const rateForms = ['w', 'a', 'j'].map((letter, order) => ({ letter, ends: ['', '_body', '_rad_s', '_body_rad_s'].map((end) => (end.endsWith('rad_s') && order > 0 ? `${end}${order + 1}` : end)) }));
const angleUnits: readonly AngleUnit[] = ['deg', 'rad', 'mrad', 'arcsec'];
const ofAxes: Readonly<Record<string, string>> = { x: 'roll', y: 'pitch', z: 'yaw' };
const ofMatrix = [...'123'].flatMap((row) => [...'123'].map((column) => `r${row}${column}`));

function timeColumn(header: Header): number {
  if (header.stated.t) return columnNamed(header, 't');
  if (header.names.includes('t')) return header.names.indexOf('t');
  const named = (names: RegExp) => header.compared.flatMap((name, i) => (names.test(name) ? [i] : []));
  const found = [timeNames, /^frames?$/].map(named).find(({ length }) => length > 0) ?? [];
  return found.length === 1 ? found[0] : -1;
}

type Orientation = Pick<Columns, 'form' | 'orientation'>;

/** The unit that all of some columns have; undefined where they differ. */
function unitFor(header: Header, columns: readonly number[], otherwise: AngleUnit | undefined): AngleUnit | undefined {
  const [unit, ...others] = columns.map((index) => angleUnits.find((one) => one === unitOf(header, index)) ?? otherwise);
  return others.every((one) => one === unit) ? unit : undefined;
}

function ofAngles(header: Header, { options }: Reading): Orientation | null {
  const order = String(options.euler ?? 'ZYX');
  const byNumber = ['e1', 'e2', 'e3'], byAxis = [...order.toLowerCase()].map((axis) => ofAxes[axis]);
  for (const names of options.euler ? [byNumber, byAxis] : [byAxis]) {
    const orientation = names.map((name) => columnWithUnit(header, name, angleUnits));
    const unit = unitFor(header, orientation, options.angle_unit as AngleUnit | undefined);
    if (unit && orientation.every((index) => index >= 0)) return { form: { kind: 'euler', order, unit }, orientation };
  }
  return null;
}

function ofVector(header: Header): Orientation | null {
  const orientation = ['rx', 'ry', 'rz'].map((name) => columnWithUnit(header, name, angleUnits)), unit = unitFor(header, orientation, 'rad');
  return unit && orientation.every((index) => index >= 0) ? { form: { kind: 'rotvec', unit }, orientation } : null;
}

function ofNames(header: Header, names: readonly string[], form: Form | null): Orientation | null {
  const orientation = names.map((name) => columnNamed(header, name));
  return orientation.every((index) => index >= 0) ? { form, orientation } : null;
}

function orientationColumns(header: Header, reading: Reading): Orientation | null {
  const forms: Record<string, () => Orientation | null> = {
    quaternion: () => ofNames(header, ['qw', 'qx', 'qy', 'qz'], null),
    euler: () => ofAngles(header, reading),
    matrix: () => ofNames(header, ofMatrix, { kind: 'matrix' }),
    rotvec: () => ofVector(header),
  };
  const asked = reading.options.input_orientation ?? (reading.options.euler ? 'euler' : undefined);
  for (const find of asked ? [forms[String(asked)]] : Object.values(forms)) {
    const found = find();
    if (found) return found;
  }
  return null;
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

const metres = (...columns: number[]): NumberColumn[] => columns.map((index) => ({ index, numerator: 1, denominator: 1 }));

/** Of rows without names: time, quaternion, position, wherever they stand. */
const unnamed = (width: number, orientation: number[], p: number[]): Columns => ({
  width, time: 0, form: null, orientation, p: p.length > 0 ? metres(...p) : null, rates: [], header: null, headerRow: null,
});

/** The formats whose rows have no names, told by the first of them and the comment above it. */
function withoutNames(cells: readonly Cell[], comment: string, { delimiter }: Table, { options }: Reading): Columns | null {
  const { length: width } = cells, isBlank = delimiter === ' ' || delimiter === '\t';
  if (options.order) return unnamed(width, options.order === 'wxyz' ? [1, 2, 3, 4] : [4, 1, 2, 3], width >= 8 ? [5, 6, 7] : []);
  if (isBlank) return width === 8 ? unnamed(width, [7, 4, 5, 6], [1, 2, 3]) : null; // TUM
  return delimiter === ',' && width >= 8 && /^#\s*timestamp\b/i.test(comment) ? unnamed(width, [4, 5, 6, 7], [1, 2, 3]) : null; // EuRoC
}

function withNames(header: Header, headerRow: number | null, reading: Reading): Columns | null {
  const time = timeColumn(header), found = orientationColumns(header, reading);
  if (time < 0 || !found) return null;
  return { width: header.names.length, time, ...found, p: placeColumns(header), rates: rateColumns(header), header, headerRow };
}

/** The names in the first line of a text that has cells. */
export function namesIn(text: string): string[] {
  const table = tableOf(text);
  return (table && cellsOf(table.lines[table.rows[0]].text, table.delimiter)?.map(({ content }) => content)) ?? [];
}

/** Null where it is not simple. */
export function columnsOf(table: Table, reading: Reading): Columns | null {
  const { lines, rows, delimiter } = table, [row] = rows;
  const cells = cellsOf(lines[row].text, delimiter);
  if (!cells) return null;
  while (cells.at(-1)?.content === '') cells.pop();
  const first = cells.find(({ content }) => content !== '')?.content;
  if (first === undefined) return null;
  const stated = String(reading.options.columns ?? '');
  if (!/^[-+.\d]/.test(first)) return withNames(headerOf(cells, stated), row, reading);
  const comment = lines.slice(0, row).findLast(({ text }) => /^[ \t]*#/.test(text))?.text ?? '';
  const plain = withoutNames(cells, comment, table, reading);
  if (plain) return plain;
  const names = cellsOf(comment.replace(/^[ \t]*#[ \t]*(HEADER:)?/, ''), delimiter);
  return names?.length === cells.length ? withNames(headerOf(names, stated), null, reading) : null;
}
