// SPDX-License-Identifier: Apache-2.0
// Faults of a file that are mended in its text, of which all other bytes stay: rows out of order, rows of one time, rows without numbers, a
// comment that names no method. Null where the file is not simple enough for that.
import { type Decimal, decimalOf, difference } from '../document/decimal';
import { textFor, type Reading } from '../document/reading';
import { columnsOf, type Columns } from './columns';
import { dateIn } from './dates';
import { cellsOf, tableOf, type Line } from './table';

interface Row {
  readonly line: Line;
  readonly cells: readonly string[];
  readonly time: Decimal | null;
}

const timeOf = (cell: string): Decimal | null => decimalOf(cell) ?? dateIn(cell)?.seconds ?? null;

const isLater = (one: Row, other: Row): boolean => difference(one.time!, other.time!).digits > 0n;
const isAtOnce = (one: Row, other: Row): boolean => difference(one.time!, other.time!).digits === 0n;

function ordered(rows: Row[]): Row[] | null {
  return rows.every(({ time }) => time) ? rows.toSorted((one, other) => Number(isLater(one, other)) - Number(isLater(other, one))) : null;
}

function withoutSecond(rows: Row[]): Row[] | null {
  if (!rows.every(({ time }) => time)) return null;
  const kept: Row[] = [];
  for (const row of rows) if (kept.length === 0 || !isAtOnce(kept[kept.length - 1], row)) kept.push(row);
  return kept;
}

function withNumbers(rows: Row[], { orientation, p }: Columns): Row[] {
  const needed = [...orientation, ...(p ?? []).map(({ index }) => index)];
  return rows.filter(({ cells, time }) => time && needed.every((index) => decimalOf(cells[index] ?? '')) && orientation.some((index) => Number(cells[index]) !== 0));
}

const mendings: Readonly<Record<string, (rows: Row[], columns: Columns) => Row[] | null>> = { sort: ordered, drop_duplicates: withoutSecond, jumps: withoutSecond, drop_invalid: withNumbers };

function withoutComment(text: string): string {
  return text.replace(/^[ \t]*#[ \t]*orispline:.*(\r?\n|$)/gm, '');
}

/** `remedy`: the library's word for what mends it. */
export function repaired(text: string, remedy: string, reading: Reading): string | null {
  if (remedy === 'recipe') return withoutComment(text);
  const table = tableOf(text), read = tableOf(textFor(text, reading)), columns = read && columnsOf(read, reading);
  if (!table || !read || !columns || !(remedy in mendings)) return null;
  const places = columns.headerRow === null ? table.rows : table.rows.slice(1);
  const rows = places.map((place) => {
    const cells = (cellsOf(read.lines[place].text, read.delimiter) ?? []).map(({ content }) => content);
    return { line: table.lines[place], cells, time: timeOf(cells[columns.time] ?? '') };
  });
  const mended = mendings[remedy](rows, columns);
  if (!mended) return null;
  const end = table.lines.find((line) => line.end !== '')?.end ?? '\n';
  // Rows that are taken out leave their own places; those that are put in order take the places of rows.
  const kept = new Set(mended.map(({ line }) => line)), isOrder = mended.length === rows.length, isEnded = table.lines.at(-1)!.end !== '';
  let next = 0;
  const lines = table.lines.flatMap((line, i) => (!places.includes(i) ? [line] : isOrder ? [mended[next++].line] : kept.has(line) ? [line] : []));
  return table.mark + lines.map(({ text: one, end: own }, i) => one + (i < lines.length - 1 || isEnded ? own || end : '')).join('');
}
