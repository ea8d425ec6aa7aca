// SPDX-License-Identifier: Apache-2.0
// The table of measures: a click on a head sorts it, a click on a row shows the method.
import { hasSamples, type Column, type Method } from '../data/report';
import { breakable, element } from '../look/element';
import { NumberColumn, powerOfTen, raised, typeset } from '../look/number';
import { sortable, type Head, type Value } from '../look/sortable';
import type { Store } from '../store/store';

const valueOf = (method: Method, id: string): Value =>
  id === 'name' ? method.name : id === 'continuity' ? method.continuity : (method.measures[id] ?? null);

/** Names of more characters, which may differ at their ends only, are shown in several lines. */
const longName = 28;

/** Who is so near to the best is as good. */
const asGood = 0.01;

/** Whether a value is as good as the best one of its column. */
function bestIn({ id, better, rounding }: Column, methods: Method[]): (value: number | null | undefined) => boolean {
  const values = methods.filter((method) => !method.failure).map((method) => method.measures[id]);
  const numbers = values.filter((value): value is number => typeof value === 'number' && Number.isFinite(value));
  if (better === 'neither' || numbers.length < 2) return () => false;
  const best = better === 'less' ? Math.min(...numbers) : Math.max(...numbers);
  const room = Math.max(asGood * Math.abs(best), rounding);
  return (value) => typeof value === 'number' && Math.abs(value - best) <= room;
}

/** How the values of a column are written, and their unit. */
interface Written {
  unit: string;
  text: (value: number | null | undefined) => string;
}

/** Counts are whole for every method. */
const isCount = ({ id, unit }: Column, methods: Method[]) => unit === '' && methods.every(({ measures }) => Number.isInteger(measures[id] ?? 0));

function writtenOf(column: Column, { moments, report: { methods } }: Store): Written {
  if (column.is_time) return { unit: '', text: (value) => (typeof value === 'number' ? moments.text(value) : '–') };
  if (isCount(column, methods)) return { unit: '', text: (value) => String(value ?? '–') };
  const values = new NumberColumn(methods.map(({ measures }) => measures[column.id]), column.rounding);
  return { unit: [powerOfTen(values.exponent), typeset(column.unit)].filter(Boolean).join(' '), text: (value) => values.text(value) };
}

const headOf = ({ id, label, explanation, better }: Column, { unit }: Written): Head => ({
  id,
  label: typeset(label),
  unit,
  explanation,
  isNumber: true,
  fromLargest: better === 'more',
});

function showButton({ choose, current }: Store, method: Method, which: 'first' | 'second'): HTMLButtonElement {
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

/** A moment in the motion of a method, which a click leads to. */
function momentButton({ choose, current, moveTo }: Store, method: Method, time: number, text: string): HTMLButtonElement {
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
    text,
  );
}

/** A column of the table, and what of it is seen. */
interface Shown {
  column: Column;
  written: Written;
  isBest: ReturnType<typeof bestIn>;
}

function cellOf(store: Store, method: Method, { column, written, isBest }: Shown): HTMLTableCellElement {
  const value = method.measures[column.id];
  const leads = column.is_time && typeof value === 'number' && hasSamples(method);
  return element('td', { className: isBest(value) ? 'number best' : 'number' }, leads ? momentButton(store, method, value, written.text(value)) : written.text(value));
}

function rowOf(store: Store, method: Method, columns: Shown[]): HTMLTableRowElement {
  const row = element('tr', { attributes: { 'data-method': method.name } });
  const picks = hasSamples(method) ? [showButton(store, method, 'first'), showButton(store, method, 'second')] : [];
  const name = element('th', { scope: 'row', title: method.name, className: method.name.length > longName ? 'long' : '' }, ...breakable(method.name));
  row.append(element('td', { className: 'picks' }, ...picks), name);
  if (method.failure) {
    row.classList.add('failed');
    row.append(element('td', { colSpan: columns.length + 1 }, method.failure));
    return row;
  }
  row.append(element('td', { className: 'continuity' }, method.continuity.replace(/C(\d)/, (_, order) => `C${raised(order)}`)));
  row.append(...columns.map((column) => cellOf(store, method, column)));
  if (hasSamples(method)) row.onclick = () => store.choose({ first: method.name });
  return row;
}

export function measureTable(store: Store): HTMLTableElement {
  const { report, current, subscribe } = store;
  const columns = report.columns.map((column): Shown => ({ column, written: writtenOf(column, store), isBest: bestIn(column, report.methods) }));
  const heads = [{ id: 'name', label: 'Method' }, { id: 'continuity', label: 'In time' }, ...columns.map(({ column, written }) => headOf(column, written))];
  const picks = element('th', { className: 'picks', scope: 'col' }, element('span', { className: 'unseen' }, 'Shown'));
  const { table, lines, sort } = sortable(heads, report.methods, { lineOf: (method) => rowOf(store, method, columns), valueOf, isLast: ({ failure }) => !!failure }, picks);
  if (report.sorted_by) sort(report.sorted_by);
  subscribe(['first', 'second'], ({ first, second }) => {
    for (const [method, row] of lines) {
      row.classList.toggle('is-first', method.name === first);
      row.classList.toggle('is-second', method.name === second);
      for (const which of ['first', 'second'] as const)
        row.querySelector(`.pick.${which}`)?.setAttribute('aria-pressed', String(current()[which] === method.name));
    }
  });
  return table;
}
