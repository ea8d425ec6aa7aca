// SPDX-License-Identifier: Apache-2.0
// The text of a file with the keys of a document in it: rows of untouched keys stay byte for byte, of others the changed cells are written;
// keys that were made are new rows, with empty cells where nothing is known.
import { type Decimal, decimalOf, numberText } from '../document/decimal';
import type { Key, Original, Quaternion } from '../document/document';
import { plainReading, textFor, type Reading } from '../document/reading';
import type { Engine } from '../engine/protocol';
import { textInUnit } from './cells';
import { type Columns, columnsOf } from './columns';
import { columnNamed } from './names';
import { type Cell, type Line, type Table, cellsOf, tableOf } from './table';
import { type TimeForm, textOfTime, timeFormOf } from './times';

/** In the place of a stretch of a line. */
interface Change {
  readonly from: number;
  readonly to: number;
  readonly text: string;
}

interface Layout {
  readonly table: Table;
  readonly columns: Columns;
  readonly reading: Reading;
  readonly rows: readonly number[]; // lines of keys
  readonly cells: readonly (readonly Cell[])[]; // of these
  readonly first: Decimal; // time of the first key that there was [s]
  readonly times: TimeForm;
  readonly kept: readonly (readonly [name: string, index: number])[]; // columns of keys' own values
  readonly added: readonly string[]; // names of further ones
  readonly removed: readonly number[];
}

/** A text that is not to be had ends the work: the file is no simple one. */
class NotSimple extends Error {}

function there<Value>(value: Value | null | undefined): Value {
  if (value === null || value === undefined) throw new NotSimple();
  return value;
}

function demand(condition: boolean): void {
  if (!condition) throw new NotSimple();
}

const namesOf = (keys: readonly Key[]): string[] => Object.keys(keys[0]?.own ?? {});

function layoutOf({ text, epoch: from, reading = plainReading }: Original, before: readonly Key[], keys: readonly Key[]): Layout {
  const table = there(tableOf(text)), read = there(tableOf(textFor(text, reading))); // cells stand at the same places of both
  const columns = there(columnsOf(read, reading));
  const rows = columns.headerRow === null ? table.rows : table.rows.slice(1);
  const cells = rows.map((row) => there(cellsOf(read.lines[row].text, read.delimiter)));
  const epoch = there(decimalOf(from)), timesOf = (row: readonly Cell[]): string => row[columns.time].content;
  demand(rows.length === before.length && rows.length > 0 && cells.every((row) => row.length >= columns.width));
  const times = there(timeFormOf(cells.map(timesOf), before, epoch, reading)), first = there(times.read(timesOf(cells[0])));
  const [old, own] = [namesOf(before), namesOf(keys)];
  const placeOf = (name: string): number => (columns.header ? columnNamed(columns.header, name) : -1);
  const added = own.filter((name) => !old.includes(name)), removed = old.filter((name) => !own.includes(name)).map(placeOf);
  demand(old.every((name) => placeOf(name) >= 0) && (columns.headerRow !== null || added.length + removed.length === 0));
  const kept = own.filter((name) => old.includes(name)).map((name) => [name, placeOf(name)] as const);
  return { table: { ...table, delimiter: read.delimiter }, columns, reading, rows, cells, first, times, kept, added, removed };
}

const isSame = (some: Quaternion, other: Quaternion): boolean => some.every((number, i) => number === other[i]);

/** q and −q are one orientation, and the sign in the file is as good as the other, but for the first key, after which all others take theirs. */
const sameOrientation = (some: Quaternion, other: Quaternion): boolean => isSame(some, other) || isSame(some, other.map((number) => -number) as unknown as Quaternion);

function hasOtherSign({ columns: { form, orientation } }: Layout, cells: readonly Cell[], { q }: Key): boolean {
  if (form) return false;
  const largest = q.reduce((best, number, i) => (Math.abs(number) > Math.abs(q[best]) ? i : best), 0);
  return Number(cells[orientation[largest]].content) * q[largest] < 0;
}

/** The row that a key was, else that which it stands behind; of those before all others the first. */
const besideOf = (keys: readonly Key[], index: number): number => keys.slice(0, index + 1).findLast(({ row }) => row !== null)?.row ?? 0;

type Stated = ReadonlyMap<number, readonly string[]>;

/** The cells of the orientations that are written, by the id of their key. */
async function statedOf({ columns: { form, orientation }, cells }: Layout, before: readonly Key[], keys: readonly Key[], engine: Engine): Promise<Stated> {
  const changed = keys.flatMap((key, index) => (key.row !== null && sameOrientation(key.q, before[key.row].q) ? [] : [{ key, beside: cells[besideOf(keys, index)] }]));
  if (!form || changed.length === 0) return new Map(keys.map(({ id, q }) => [id, q.map(numberText)]));
  const beside = changed.map((one) => orientation.map((index) => Number(one.beside[index].content)));
  const stated = await engine.ask('stated', { orientations: changed.map(({ key }) => key.q), form, beside });
  return new Map(changed.map(({ key }, k) => [key.id, stated[k].texts]));
}

/** Texts by their columns, of what is not as it was before; of a new key of all that is known. */
function textsOf({ columns, first, times, kept, reading }: Layout, stated: Stated, key: Key, before: Key | null, like: string, otherSign = false): Map<number, string> {
  const texts = new Map<number, string>();
  const put = (index: number, text: string) => texts.set(index, reading.comma ? text.replace('.', ',') : text);
  if (!Object.is(key.t, before?.t)) put(columns.time, there(textOfTime(key.t, first, times, like)));
  if (!before || otherSign || !sameOrientation(key.q, before.q)) columns.orientation.forEach((index, i) => put(index, there(stated.get(key.id))[i]));
  key.p?.forEach((value, i) => {
    if (!Object.is(value, before?.p?.[i])) put(there(columns.p)[i].index, there(textInUnit(value, columns.p![i])));
  });
  for (const [name, index] of kept) if (!Object.is(key.own[name], before?.own[name])) put(index, numberText(key.own[name]));
  if (!before)
    key.rates.forEach((rate, order) => {
      if (!rate.every(Number.isNaN)) rate.forEach((value, i) => put(there(columns.rates[order])[i], numberText(value)));
    });
  return texts;
}

function withChanges(line: string, changes: readonly Change[]): string {
  return changes.toSorted((one, other) => other.from - one.from || other.to - one.to).reduce((text, { from, to, text: part }) => text.slice(0, from) + part + text.slice(to), line);
}

/** Without some columns, and with further ones behind the last. */
function reshaped(layout: Layout, cells: readonly Cell[], more: readonly string[]): Change[] {
  const { columns, removed, table } = layout;
  const without = removed.map((index) =>
    index > 0 ? { from: cells[index - 1].to, to: cells[index].to, text: '' } : { from: cells[0].from, to: cells[1].from, text: '' },
  );
  const end = cells[columns.width - 1].to;
  return more.length > 0 ? [...without, { from: end, to: end, text: more.map((text) => table.delimiter + text).join('') }] : without;
}

const addedOf = ({ added, reading }: Layout, key: Key): string[] => added.map((name) => (reading.comma ? numberText(key.own[name]).replace('.', ',') : numberText(key.own[name])));

function changedRow(layout: Layout, stated: Stated, row: number, key: Key, before: Key, isFirst: boolean): string {
  const line = layout.table.lines[layout.rows[row]].text;
  const cells = layout.cells[row], like = cells[layout.columns.time].content;
  const changes = [...textsOf(layout, stated, key, before, like, isFirst && hasOtherSign(layout, cells, key))].map(([index, text]) => {
    const { from, to } = cells[index];
    return { from, to, text: line[from] === '"' ? `"${text}"` : text };
  });
  return withChanges(line, [...changes, ...reshaped(layout, cells, addedOf(layout, key))]);
}

/** With what stands between the first cells of the row beside it. */
function newRow(layout: Layout, stated: Stated, key: Key, beside: number): string {
  const { columns, table, removed } = layout;
  const line = table.lines[layout.rows[beside]].text;
  const [first, second] = layout.cells[beside];
  const texts = textsOf(layout, stated, key, null, layout.cells[beside][columns.time].content);
  const empty = table.delimiter === ' ' ? 'nan' : '';
  const cells = Array.from({ length: columns.width }, (_, index) => texts.get(index) ?? empty).filter((_, index) => !removed.includes(index));
  return line.slice(0, first.from) + [...cells, ...addedOf(layout, key)].join(line.slice(first.to, second.from));
}

/** New rows by the row that they stand behind; −1: before all others. */
function newRows(layout: Layout, stated: Stated, keys: readonly Key[]): Map<number, string[]> {
  const texts = new Map<number, string[]>();
  let behind = -1;
  for (const key of keys) {
    if (key.row === null) texts.set(behind, [...(texts.get(behind) ?? []), newRow(layout, stated, key, Math.max(behind, 0))]);
    else behind = key.row;
  }
  return texts;
}

function composedLines(layout: Layout, stated: Stated, before: readonly Key[], keys: readonly Key[]): Line[] {
  const { lines } = layout.table;
  const end = lines.find((line) => line.end !== '')?.end ?? '\n';
  const fresh = newRows(layout, stated, keys);
  const kept = new Map(keys.flatMap((key) => (key.row === null ? [] : [[key.row, key] as const])));
  const rowOf = new Map(layout.rows.map((line, row) => [line, row]));
  const made = (row: number): Line[] => (fresh.get(row) ?? []).map((text) => ({ text, end }));
  return lines.flatMap((line, i) => {
    const row = rowOf.get(i);
    if (row === undefined) return [i === layout.columns.headerRow ? { ...line, text: headerText(layout, line.text) } : line];
    const key = kept.get(row);
    const itself = key ? [{ ...line, text: changedRow(layout, stated, row, key, before[row], key === keys[0]) }] : [];
    return [...(row === 0 ? made(-1) : []), ...itself, ...made(row)];
  });
}

const headerText = (layout: Layout, line: string): string => withChanges(line, reshaped(layout, there(cellsOf(line, layout.table.delimiter)), layout.added));

export interface Exact {
  readonly orientations: boolean; // they are quaternions
  readonly times: boolean; // decimals express them
}

export interface Composed {
  readonly text: string;
  readonly exact: Exact; // what it holds of keys to the last bit
}

/** The text; null where the file is no simple one. `before`: what the library reads out of it. */
export async function composed(original: Original, before: readonly Key[], keys: readonly Key[], engine: Engine): Promise<Composed | null> {
  try {
    const layout = layoutOf(original, before, keys);
    const lines = composedLines(layout, await statedOf(layout, before, keys, engine), before, keys);
    const isEnded = layout.table.lines.at(-1)!.end !== ''; // if not, it stays so
    const end = lines.find((line) => line.end !== '')?.end ?? '\n';
    const ended = lines.map((line, i) => line.text + (i < lines.length - 1 || isEnded ? line.end || end : ''));
    return { text: layout.table.mark + ended.join(''), exact: { orientations: layout.columns.form === null, times: layout.times.isExact } };
  } catch (error) {
    if (error instanceof NotSimple) return null;
    throw error;
  }
}
