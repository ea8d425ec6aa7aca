// SPDX-License-Identifier: Apache-2.0
// The text of a file with the keys of a document in it: rows of untouched keys stay byte for byte, of others the changed cells are written;
// keys that were made are new rows, with empty cells where nothing is known.
import { type Decimal, decimalOf, numberText } from '../document/decimal';
import type { Key, Original, Quaternion } from '../document/document';
import { textInUnit, textOfTime, unitOfTimes } from './cells';
import { type Columns, columnNamed, columnsOf } from './columns';
import { type Cell, type Line, type Table, cellsOf, tableOf } from './table';

/** In the place of a stretch of a line. */
interface Change {
  readonly from: number;
  readonly to: number;
  readonly text: string;
}

interface Layout {
  readonly table: Table;
  readonly columns: Columns;
  readonly rows: readonly number[]; // lines of keys
  readonly cells: readonly (readonly Cell[])[]; // of these
  readonly epoch: Decimal;
  readonly power: number; // of ten, of the unit of times [s]
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

function layoutOf(original: Original, before: readonly Key[], keys: readonly Key[]): Layout {
  const table = there(tableOf(original.text));
  const columns = there(columnsOf(table));
  const rows = columns.header ? table.rows.slice(1) : table.rows;
  const cells = rows.map((row) => there(cellsOf(table.lines[row].text, table.delimiter)));
  const epoch = there(decimalOf(original.epoch));
  demand(rows.length === before.length && rows.length > 0 && cells.every((row) => row.length >= columns.width));
  const power = there(unitOfTimes(cells.map((row) => row[columns.time].content), before, epoch));
  const [old, own] = [namesOf(before), namesOf(keys)];
  const placeOf = (name: string): number => (columns.header ? columnNamed(columns.header, name) : -1);
  demand(old.every((name) => placeOf(name) >= 0) && (columns.header !== null || own.length === 0));
  const kept = own.filter((name) => old.includes(name)).map((name) => [name, placeOf(name)] as const);
  const removed = old.filter((name) => !own.includes(name)).map(placeOf);
  return { table, columns, rows, cells, epoch, power, kept, added: own.filter((name) => !old.includes(name)), removed };
}

const isSame = (some: Quaternion, other: Quaternion): boolean => some.every((number, i) => number === other[i]);

/** q and −q are one orientation, and the sign in the file is as good as the other, but for the first key, after which all others take theirs. */
const sameOrientation = (some: Quaternion, other: Quaternion): boolean => isSame(some, other) || isSame(some, other.map((number) => -number) as unknown as Quaternion);

function hasOtherSign({ columns }: Layout, cells: readonly Cell[], { q }: Key): boolean {
  const largest = q.reduce((best, number, i) => (Math.abs(number) > Math.abs(q[best]) ? i : best), 0);
  return Number(cells[columns.q[largest]].content) * q[largest] < 0;
}

/** Texts by their columns, of what is not as it was before; of a new key of all that is known. */
function textsOf({ columns, epoch, power, kept }: Layout, key: Key, before: Key | null, otherSign = false): Map<number, string> {
  const texts = new Map<number, string>();
  if (!Object.is(key.t, before?.t)) texts.set(columns.time, there(textOfTime(key.t, epoch, power)));
  if (!before || otherSign || !sameOrientation(key.q, before.q)) columns.q.forEach((index, i) => texts.set(index, numberText(key.q[i])));
  key.p?.forEach((value, i) => {
    if (!Object.is(value, before?.p?.[i])) texts.set(there(columns.p)[i].index, there(textInUnit(value, columns.p![i])));
  });
  for (const [name, index] of kept) if (!Object.is(key.own[name], before?.own[name])) texts.set(index, numberText(key.own[name]));
  if (!before)
    key.rates.forEach((rate, order) => {
      if (!rate.every(Number.isNaN)) rate.forEach((value, i) => texts.set(there(columns.rates[order])[i], numberText(value)));
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

function changedRow(layout: Layout, row: number, key: Key, before: Key, isFirst: boolean): string {
  const line = layout.table.lines[layout.rows[row]].text;
  const cells = layout.cells[row];
  const changes = [...textsOf(layout, key, before, isFirst && hasOtherSign(layout, cells, key))].map(([index, text]) => {
    const { from, to } = cells[index];
    return { from, to, text: line[from] === '"' ? `"${text}"` : text };
  });
  return withChanges(line, [...changes, ...reshaped(layout, cells, layout.added.map((name) => numberText(key.own[name])))]);
}

/** With what stands between the first cells of the row beside it. */
function newRow(layout: Layout, key: Key, beside: number): string {
  const { columns, table, added, removed } = layout;
  const line = table.lines[layout.rows[beside]].text;
  const [first, second] = layout.cells[beside];
  const texts = textsOf(layout, key, null);
  const empty = table.delimiter === ' ' ? 'nan' : '';
  const cells = Array.from({ length: columns.width }, (_, index) => texts.get(index) ?? empty).filter((_, index) => !removed.includes(index));
  return line.slice(0, first.from) + [...cells, ...added.map((name) => numberText(key.own[name]))].join(line.slice(first.to, second.from));
}

/** New rows by the row that they stand behind; −1: before all others. */
function newRows(layout: Layout, keys: readonly Key[]): Map<number, string[]> {
  const texts = new Map<number, string[]>();
  let behind = -1;
  for (const key of keys) {
    if (key.row === null) texts.set(behind, [...(texts.get(behind) ?? []), newRow(layout, key, Math.max(behind, 0))]);
    else behind = key.row;
  }
  return texts;
}

function composedLines(layout: Layout, before: readonly Key[], keys: readonly Key[]): Line[] {
  const { lines, rows } = layout.table;
  const end = lines.find((line) => line.end !== '')?.end ?? '\n';
  const fresh = newRows(layout, keys);
  const kept = new Map(keys.flatMap((key) => (key.row === null ? [] : [[key.row, key] as const])));
  const rowOf = new Map(layout.rows.map((line, row) => [line, row]));
  const made = (row: number): Line[] => (fresh.get(row) ?? []).map((text) => ({ text, end }));
  return lines.flatMap((line, i) => {
    const row = rowOf.get(i);
    if (row === undefined) return [layout.columns.header && i === rows[0] ? { ...line, text: headerText(layout, line.text) } : line];
    const key = kept.get(row);
    const itself = key ? [{ ...line, text: changedRow(layout, row, key, before[row], key === keys[0]) }] : [];
    return [...(row === 0 ? made(-1) : []), ...itself, ...made(row)];
  });
}

const headerText = (layout: Layout, line: string): string => withChanges(line, reshaped(layout, there(cellsOf(line, layout.table.delimiter)), layout.added));

/** The text; null where the file is no simple one. `before`: what the library reads out of it. */
export function composed(original: Original, before: readonly Key[], keys: readonly Key[]): string | null {
  try {
    const layout = layoutOf(original, before, keys);
    const lines = composedLines(layout, before, keys);
    const isEnded = layout.table.lines.at(-1)!.end !== ''; // if not, it stays so
    const end = lines.find((line) => line.end !== '')?.end ?? '\n';
    const ended = lines.map((line, i) => line.text + (i < lines.length - 1 || isEnded ? line.end || end : ''));
    return layout.table.mark + ended.join('');
  } catch (error) {
    if (error instanceof NotSimple) return null;
    throw error;
  }
}
