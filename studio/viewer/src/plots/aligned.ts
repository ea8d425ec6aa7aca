// SPDX-License-Identifier: Apache-2.0
// Lines over times of their own as the columns over one list of times that uPlot draws.
import type uPlot from 'uplot';
import type { Numbers } from '../data/numbers';
import type { Course } from '../quantities/quantity';

/** Of a column: nothing in this row (undefined) joins its neighbours, a gap (null) does not. */
type Column = (number | null | undefined)[];

/** With null instead of NaN. */
const drawable = (values: Numbers) => (values.some(Number.isNaN) ? Array.from(values, (value) => (Number.isNaN(value) ? null : value)) : values);

/** A gap goes on over the times of the other lines. */
function widenGaps(column: Column): void {
  for (let i = 1; i < column.length; ++i) if (column[i] === undefined && column[i - 1] === null) column[i] = null;
  for (let i = column.length - 1; i > 0; --i) if (column[i - 1] === undefined && column[i] === null) column[i - 1] = null;
}

/** All times of all lines; a jump of one line is two rows. */
function joined(lines: Course[]): uPlot.AlignedData {
  const times: number[] = [];
  const columns: Column[] = lines.map(() => []);
  const next = lines.map(() => 0);
  for (;;) {
    const time = Math.min(...lines.map(({ t }, k) => (next[k] < t.length ? t[next[k]] : Infinity)));
    if (time === Infinity) break;
    const row = times.length;
    let rows = 0;
    lines.forEach(({ t, values }, k) => {
      for (let i = row; t[next[k]] === time; ++i, ++next[k]) {
        columns[k][i] = Number.isNaN(values[next[k]]) ? null : values[next[k]];
        rows = Math.max(rows, i + 1 - row);
      }
    });
    for (let i = 0; i < rows; ++i) times.push(time);
  }
  for (const column of columns) {
    column.length = times.length;
    widenGaps(column);
  }
  return [times, ...columns];
}

/** Where there are no lines, over the extent. */
export function aligned(lines: Course[], extent: [number, number]): uPlot.AlignedData {
  if (lines.length === 0) return [[...extent]];
  if (lines.every(({ t }) => t === lines[0].t)) return [lines[0].t, ...lines.map(({ values }) => drawable(values))] as uPlot.AlignedData;
  return joined(lines);
}
