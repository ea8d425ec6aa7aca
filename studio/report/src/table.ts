// SPDX-License-Identifier: Apache-2.0
// The table of measures: a click on a head sorts it, a click on a row shows the method.
import { moment } from './clock';
import { element, place } from './element';
import { shown } from './number';
import { hasSamples, report, type Column, type Method } from './report';
import { choose, current, moveTo, subscribe } from './state';

type Order = { id: string; descending: boolean };

const valueOf = (method: Method, id: string): number | string | null =>
  id === 'name' ? method.name : id === 'continuity' ? method.continuity : (method.measures[id] ?? null);

const isMissing = (value: number | string | null) => value === null || (typeof value === 'number' && !Number.isFinite(value));

/** Failed methods and missing values stay at the end in either direction. */
function compared(a: Method, b: Method, { id, descending }: Order): number {
  if (!a.failure !== !b.failure) return a.failure ? 1 : -1;
  const [x, y] = [valueOf(a, id), valueOf(b, id)];
  if (isMissing(x) || isMissing(y)) return Number(isMissing(x)) - Number(isMissing(y));
  const ascending = typeof x === 'number' ? x - (y as number) : x!.localeCompare(String(y), 'en', { numeric: true });
  return descending ? -ascending : ascending;
}

/** Who is so near to the best is as good. */
const asGood = 0.01;

/** Whether a value is as good as the best one of its column. */
function bestIn({ id, better, rounding }: Column): (value: number | null | undefined) => boolean {
  const values = report.methods.filter((method) => !method.failure).map((method) => method.measures[id]);
  const numbers = values.filter((value): value is number => typeof value === 'number' && Number.isFinite(value));
  if (better === 'neither' || numbers.length < 2) return () => false;
  const best = better === 'less' ? Math.min(...numbers) : Math.max(...numbers);
  const room = Math.max(asGood * Math.abs(best), rounding);
  return (value) => typeof value === 'number' && Math.abs(value - best) <= room;
}

function headOf(column: Pick<Column, 'id' | 'label'> & Partial<Column>, sort: (id: string) => void): HTMLTableCellElement {
  const label = element('button', { type: 'button', title: column.explanation ?? '', onclick: () => sort(column.id) }, column.label);
  if (column.unit && !column.is_time) label.append(element('small', {}, ` [${column.unit}]`));
  return element('th', { scope: 'col', className: column.better ? 'number' : '', attributes: { 'data-id': column.id } }, label);
}

function showButton(method: Method, which: 'first' | 'second'): HTMLButtonElement {
  const words = which === 'first' ? 'Show' : 'Show beside it';
  return element('button', {
    type: 'button',
    className: `pick ${which}`,
    title: `${words}: ${method.name}`,
    onclick: (event) => {
      event.stopPropagation();
      const off = which === 'second' && current().second === method.name;
      choose({ [which]: off ? null : method.name });
    },
    attributes: { 'aria-label': `${words}: ${method.name}` },
  });
}

/** Counts are whole for every method. */
const isCount = ({ id, unit }: Column) => unit === '' && report.methods.every(({ measures }) => Number.isInteger(measures[id] ?? 0));

/** A moment in the motion of a method, which a click leads to. */
function momentButton(method: Method, time: number): HTMLButtonElement {
  return element(
    'button',
    {
      type: 'button',
      className: 'moment',
      title: `Go there: ${method.name}`,
      onclick: (event) => {
        event.stopPropagation();
        if (current().second !== method.name) choose({ first: method.name });
        moveTo(time);
      },
    },
    moment(time),
  );
}

function textOf(column: Column, value: number | null | undefined): string {
  if (column.is_time && typeof value === 'number') return moment(value);
  return isCount(column) && value !== undefined ? String(value ?? '–') : shown(value, column.rounding);
}

function cellOf(method: Method, column: Column, isBest: ReturnType<typeof bestIn>): HTMLTableCellElement {
  const value = method.measures[column.id];
  const leads = column.is_time && typeof value === 'number' && hasSamples(method);
  return element('td', { className: isBest(value) ? 'number best' : 'number' }, leads ? momentButton(method, value) : textOf(column, value));
}

function rowOf(method: Method, best: Map<string, ReturnType<typeof bestIn>>): HTMLTableRowElement {
  const row = element('tr', { attributes: { 'data-method': method.name } });
  const picks = hasSamples(method) ? [showButton(method, 'first'), showButton(method, 'second')] : [];
  row.append(element('td', { className: 'picks' }, ...picks), element('th', { scope: 'row', title: method.name }, method.name));
  if (method.failure) {
    row.classList.add('failed');
    row.append(element('td', { colSpan: report.columns.length + 1 }, method.failure));
    return row;
  }
  row.append(element('td', {}, method.continuity.replace(/C(\d)/, (_, order) => `C${'⁰¹²³⁴⁵⁶⁷⁸⁹'[order]}`)));
  row.append(...report.columns.map((column) => cellOf(method, column, best.get(column.id)!)));
  if (hasSamples(method)) row.onclick = () => choose({ first: method.name });
  return row;
}

export function showTable(): void {
  const best = new Map(report.columns.map((column) => [column.id, bestIn(column)]));
  const rows = new Map(report.methods.map((method) => [method, rowOf(method, best)]));
  const body = element('tbody', {}, ...rows.values());
  const heads: HTMLTableCellElement[] = [];
  let order: Order | null = null;

  function sort(id: string): void {
    const column = report.columns.find((candidate) => candidate.id === id);
    const descending = order?.id === id ? !order.descending : column?.better === 'more';
    order = { id, descending };
    const sorted = [...report.methods].sort((a, b) => compared(a, b, order!));
    body.append(...sorted.map((method) => rows.get(method)!));
    for (const head of heads)
      head.setAttribute('aria-sort', head.dataset.id !== id ? 'none' : descending ? 'descending' : 'ascending');
  }

  heads.push(...[{ id: 'name', label: 'Method' }, { id: 'continuity', label: 'In time' }, ...report.columns].map((column) => headOf(column, sort)));
  const head = element('tr', {}, element('th', { className: 'picks', scope: 'col' }, element('span', { className: 'unseen' }, 'Shown')), ...heads);
  place('measures').append(element('table', {}, element('thead', {}, head), body));
  if (report.sorted_by) sort(report.sorted_by);
  subscribe(['first', 'second'], ({ first, second }) => {
    for (const [method, row] of rows) {
      row.classList.toggle('is-first', method.name === first);
      row.classList.toggle('is-second', method.name === second);
      for (const which of ['first', 'second'] as const)
        row.querySelector(`.pick.${which}`)?.setAttribute('aria-pressed', String(current()[which] === method.name));
    }
  });
}
