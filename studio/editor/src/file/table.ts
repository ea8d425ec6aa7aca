// SPDX-License-Identifier: Apache-2.0
// The text of a table as lines and cells, read as the library reads them. Nothing of it is lost: lines and what ends them, put together
// again, are the text.

export type Delimiter = ',' | ';' | '\t' | ' '; // the last stands for blanks in any number

export interface Line {
  readonly text: string;
  readonly end: string; // '\n', '\r\n', or '' after the last one
}

export interface Cell {
  readonly from: number; // in the text of its line, without the blanks around it
  readonly to: number;
  readonly content: string; // without quotes
}

const byteOrderMark = '\uFEFF';

export interface Table {
  readonly mark: string; // the byte order mark, where there is one
  readonly lines: readonly Line[];
  readonly rows: readonly number[]; // lines that have cells
  readonly delimiter: Delimiter;
}

function linesOf(text: string): Line[] {
  return (text.match(/[^\n]*\n|[^\n]+$/g) ?? []).map((line) => {
    const end = /\r?\n$/.exec(line)?.[0] ?? '';
    return { text: line.slice(0, line.length - end.length), end };
  });
}

const isBlank = (c: string): boolean => c === ' ' || c === '\t';

/** Where the quotes that stand at a place of a text end; -1 where they do not. */
function closingQuote(text: string, from: number): number {
  let at = text.indexOf('"', from + 1);
  while (at >= 0 && text[at + 1] === '"') at = text.indexOf('"', at + 2);
  return at;
}

/** The characters outside of quotes that begin a cell. */
function withoutQuoted(text: string): string {
  let rest = '';
  for (let at = 0, begins = true; at < text.length; at++) {
    const closing: number = begins && text[at] === '"' ? closingQuote(text, at) : -1;
    if (closing >= 0) at = closing;
    else rest += text[at];
    begins = closing < 0 && /[,; \t]/.test(text[at]);
  }
  return rest;
}

function delimiterOf(line: string): Delimiter {
  const text = withoutQuoted(line.trim());
  return ([';', ',', '\t'] as const).find((delimiter) => text.includes(delimiter)) ?? ' ';
}

/** A text as a table; null where it is none that the library reads. */
export function tableOf(text: string): Table | null {
  const mark = text.startsWith(byteOrderMark) ? byteOrderMark : '';
  const lines = linesOf(text.slice(mark.length));
  if (lines.some((line) => /[\r\0]/.test(line.text))) return null;
  const rows = lines.flatMap((line, i) => (/^[ \t]*(#|$)/.test(line.text) ? [] : [i]));
  return rows.length > 0 ? { mark, lines, rows, delimiter: delimiterOf(lines[rows[0]].text) } : null;
}

const unquoted = (cell: string): string => cell.slice(1, -1).replace(/^[ \t]+|[ \t]+$/g, '').replaceAll('""', '"');

/** The cells of a line; null where a quote is not closed. */
export function cellsOf(line: string, delimiter: Delimiter): Cell[] | null {
  const cells: Cell[] = [];
  const end = delimiter === ' ' ? line.replace(/[ \t]+$/, '').length : line.length;
  for (let at = 0; at <= end; ) {
    while (delimiter !== '\t' && at < end && isBlank(line[at])) at++;
    const closing: number = line[at] === '"' ? closingQuote(line, at) : at - 1;
    if (line[at] === '"' && closing < 0) return null;
    let next = closing + 1;
    while (next < end && !(delimiter === ' ' ? isBlank(line[next]) : line[next] === delimiter)) next++;
    let [from, to] = [at, next];
    while (to > from && isBlank(line[to - 1])) to--;
    while (from < to && isBlank(line[from])) from++;
    const cell = line.slice(from, to);
    cells.push({ from, to, content: closing >= at && to === closing + 1 ? unquoted(cell) : cell });
    at = next + 1;
  }
  return cells;
}
