// SPDX-License-Identifier: Apache-2.0
// All keys in a table, where every number can be typed: what the timeline shows, for who would rather read or type.
import { element } from 'orispline-viewer/look/element';
import type { Key } from '../document/document';
import { ownParameters, type OwnParameter } from '../store/parameters';
import { jumps, ordersOf, reachedText } from '../store/reached';
import type { Studio } from '../store/studio';
import { KeyFields } from './keyFields';
import type { NumberField } from './numberField';
import type { Orientations } from './orientation';

const mostRows = 200; // of more keys those near the chosen one are shown

interface Columns {
  own: OwnParameter[];
}

class Row {
  readonly element = element('tr');
  private readonly reached = element('td', { className: 'reached' });
  private readonly head: HTMLButtonElement;
  private readonly fields: KeyFields;
  private readonly numbers: { field: NumberField; valueOf: (key: Key) => number }[];
  private number = 0;

  constructor(
    private readonly studio: Studio,
    orientations: Orientations,
    id: number,
    { own }: Columns,
  ) {
    const name = (what: string) => `${what} of key ${this.number}`;
    this.number = studio.store.current().document.keys.findIndex((key) => key.id === id) + 1;
    const fields = (this.fields = new KeyFields(studio, orientations, () => id, name));
    this.fields.shown = () => this.show(this.number - 1);
    this.numbers = [
      { field: fields.time(), valueOf: ({ t }) => t },
      ...fields.orientation().map((field, i) => ({ field, valueOf: (key: Key) => orientations.numbersOf(key)[i] })),
      ...own.map((parameter) => ({ field: fields.own(parameter), valueOf: () => fields.valueOf(parameter) })),
      ...(fields.key?.p ? fields.position().map((field, i) => ({ field, valueOf: ({ p }: Key) => p![i] })) : []),
    ];
    this.head = element('button', { type: 'button', className: 'pick-key', onclick: () => studio.store.choose(id) });
    this.element.append(element('th', { scope: 'row' }, this.head), ...this.numbers.map(({ field }) => element('td', {}, field.element)), this.reached);
    this.element.addEventListener('focusin', () => studio.store.choose(id));
  }

  show(index: number): void {
    const { key } = this.fields;
    const state = this.studio.store.current();
    if (!key) return;
    this.number = index + 1;
    const order = ordersOf(state)?.[index];
    this.head.textContent = String(this.number);
    this.head.setAttribute('aria-label', `Key ${this.number}`);
    for (const { field, valueOf } of this.numbers) field.show(valueOf(key));
    this.reached.textContent = order === undefined ? '' : `${jumps(order) ? '◇' : '◆'} ${reachedText(order)}`;
    const isChosen = state.chosen === key.id;
    this.element.classList.toggle('is-chosen', isChosen);
    this.head.setAttribute('aria-pressed', String(isChosen));
  }
}

export class KeyTable {
  readonly element = element('div', { className: 'key-table', attributes: { role: 'group', 'aria-label': 'Keys' } });
  private readonly head = element('tr');
  private readonly body = element('tbody');
  private readonly note = element('p', { className: 'facts' });
  private readonly rows = new Map<number, Row>(); // by the id of the key
  private made = ''; // what the columns are
  private reached: number | null = null; // the key whose row is in view

  constructor(
    private readonly studio: Studio,
    private readonly orientations: Orientations,
  ) {
    const table = element('table', {}, element('caption', { className: 'unseen' }, 'Keys'), element('thead', {}, this.head), this.body);
    const rows = element('div', { className: 'rows', tabIndex: 0, attributes: { role: 'region', 'aria-label': 'Table of keys' } }, table);
    this.element.append(element('div', { className: 'title' }, element('h2', {}, 'Keys'), orientations.menu()), rows, this.note);
    orientations.watch(() => this.show());
    studio.store.subscribe(['document', 'chosen', 'curves'], () => this.show());
  }

  /** While it is hidden nothing is written into it. */
  set hidden(hidden: boolean) {
    this.element.hidden = hidden;
    this.show();
  }

  private show(): void {
    if (this.element.hidden) return;
    const { document, chosen } = this.studio.store.current();
    const { keys } = document;
    const columns = { own: ownParameters(document, this.studio.methods) };
    this.makeHead(columns);
    const here = Math.max(0, keys.findIndex(({ id }) => id === chosen));
    const first = Math.max(0, Math.min(here - mostRows / 2, keys.length - mostRows));
    const shown = keys.slice(first, first + mostRows);
    const gone = new Set(this.rows.keys());
    shown.forEach(({ id }, i) => {
      gone.delete(id);
      if (!this.rows.has(id)) this.rows.set(id, new Row(this.studio, this.orientations, id, columns));
      const row = this.rows.get(id)!;
      if (this.body.children[i] !== row.element) this.body.insertBefore(row.element, this.body.children[i] ?? null);
      row.show(first + i);
    });
    for (const id of gone) {
      this.rows.get(id)!.element.remove();
      this.rows.delete(id);
    }
    if (chosen !== this.reached && !this.body.contains(globalThis.document.activeElement)) this.rows.get(chosen ?? NaN)?.element.scrollIntoView({ block: 'nearest' });
    this.reached = chosen;
    this.note.textContent = shown.length < keys.length ? `Of ${keys.length} keys ${shown.length} near the chosen one are shown.` : '';
    this.note.hidden = this.note.textContent === '';
  }

  private makeHead({ own }: Columns): void {
    const form = this.orientations.current;
    const hasPositions = !!this.studio.store.current().document.keys[0]?.p;
    const unit = (name: string, unit: string) => [name, ...(unit ? [element('small', {}, ` [${unit}]`)] : [])];
    const titles = [
      ['Key'],
      unit('Time', 's'),
      ...form.names.map((name) => unit(name.split(',')[0], form.unit)),
      ...own.map(({ info }) => [info.name]),
      ...(hasPositions ? ['x', 'y', 'z'].map((axis) => unit(axis, 'm')) : []),
      ['Curve at the key'],
    ];
    const made = [form.id, hasPositions, ...own.map(({ which, info }) => `${which}:${info.name}`)].join();
    if (made === this.made) return;
    this.made = made;
    this.rows.clear();
    this.body.replaceChildren();
    this.element.style.setProperty('--numbers', String(titles.length - 2));
    this.head.replaceChildren(...titles.map((title) => element('th', { scope: 'col' }, ...title)));
  }
}
