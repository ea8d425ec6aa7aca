// SPDX-License-Identifier: Apache-2.0
// A table that a click on a head sorts, and a second one the other way round.
import { element } from './element';

export type Value = number | string | null;

export interface Head {
  id: string;
  label: string;
  unit?: string;
  explanation?: string; // shown where the cursor rests
  isNumber?: boolean;
  fromLargest?: boolean; // how a first click sorts
}

export interface Lines<Row> {
  lineOf: (row: Row) => HTMLTableRowElement;
  valueOf: (row: Row, id: string) => Value;
  isLast?: (row: Row) => boolean; // whether it stays at the end
}

const isMissing = (value: Value) => value === null || (typeof value === 'number' && !Number.isFinite(value));

/** Missing values stay at the end in either direction. */
function compared(x: Value, y: Value, descending: boolean): number {
  if (isMissing(x) || isMissing(y)) return Number(isMissing(x)) - Number(isMissing(y));
  const ascending = typeof x === 'number' ? x - (y as number) : x!.localeCompare(String(y), 'en', { numeric: true });
  return descending ? -ascending : ascending;
}

function headOf({ id, label, unit, explanation, isNumber }: Head, sort: (id: string) => void): HTMLTableCellElement {
  const button = element('button', { type: 'button', title: explanation ?? '', onclick: () => sort(id) }, label);
  if (unit) button.append(element('small', {}, ` [${unit}]`));
  return element('th', { scope: 'col', className: isNumber ? 'number' : '', attributes: { 'data-id': id } }, button);
}

/** The rows stand as they come until they are sorted. `leading` are heads that do not sort. */
export function sortable<Row>(heads: Head[], rows: Row[], { lineOf, valueOf, isLast = () => false }: Lines<Row>, ...leading: HTMLTableCellElement[]) {
  const lines = new Map(rows.map((row) => [row, lineOf(row)]));
  const body = element('tbody', {}, ...lines.values());
  let order: { id: string; descending: boolean } | null = null;

  function sort(id: string): void {
    const descending = order?.id === id ? !order.descending : !!heads.find((head) => head.id === id)?.fromLargest;
    order = { id, descending };
    const sorted = [...rows].sort((a, b) => Number(isLast(a)) - Number(isLast(b)) || compared(valueOf(a, id), valueOf(b, id), descending));
    body.append(...sorted.map((row) => lines.get(row)!));
    for (const cell of cells) cell.setAttribute('aria-sort', cell.dataset.id !== id ? 'none' : descending ? 'descending' : 'ascending');
  }

  const cells = heads.map((head) => headOf(head, sort));
  const table = element('table', {}, element('thead', {}, element('tr', {}, ...leading, ...cells)), body);
  return { table, lines, sort };
}
