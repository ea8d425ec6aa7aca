// SPDX-License-Identifier: Apache-2.0
// The keys in a table, where they are typed anew, added and taken away.
import { Cell } from 'orispline-viewer/look/cell';
import type { Edit } from './model';

const names = ['t', 'qw', 'qx', 'qy', 'qz', 'px', 'py', 'pz'];
const units: Record<string, string> = { t: 's', px: 'm', py: 'm', pz: 'm' };
const mostRows = 200; // of more keys those near the time are shown

export interface Editor {
  send: (edit: Edit) => void;
  time: () => number;
  goTo: (time: number) => void;
}

const made = <Tag extends keyof HTMLElementTagNameMap>(tag: Tag, properties: Partial<HTMLElementTagNameMap[Tag]> = {}, ...children: (Node | string)[]) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

class Row {
  readonly element = made('tr');
  private readonly cells: Cell[];
  private time = NaN;
  private sent = ''; // what was typed and is on its way, or was refused

  constructor(
    readonly key: number,
    width: number,
    private readonly editor: Editor,
  ) {
    this.cells = names.slice(0, width).map((name) => new Cell(`${name} of key ${key}`));
    const number = made('button', { type: 'button', title: 'Show this moment', onclick: () => editor.goTo(this.time) }, String(key));
    number.setAttribute('aria-label', `Show key ${key}`);
    const remove = made('button', { type: 'button', onclick: () => editor.send({ kind: 'delete', key }) }, 'Delete');
    remove.setAttribute('aria-label', `Delete key ${key}`);
    const head = made('th', {}, number);
    head.scope = 'row';
    this.element.append(head, ...this.cells.map(({ input }) => made('td', {}, input)), made('td', {}, remove));
    this.element.addEventListener('focusout', ({ relatedTarget }) => !this.element.contains(relatedTarget as Node | null) && this.commit());
    this.element.addEventListener('keydown', (event) => this.hear(event));
  }

  show(numbers: number[]): void {
    this.time = numbers[0];
    this.sent = '';
    this.cells.forEach((cell, i) => cell.show(numbers[i]));
    this.element.classList.remove('refused');
  }

  refuse(): void {
    this.element.classList.add('refused');
  }

  private hear({ key, target }: KeyboardEvent): void {
    if (!(target instanceof HTMLInputElement)) return;
    if (key === 'Enter') this.commit();
    if (key === 'Escape') this.cells.forEach((cell) => cell.reset());
  }

  /** The whole row at once: the numbers of a quaternion have a meaning together only. */
  private commit(): void {
    const [t, ...others] = this.cells.map((cell) => cell.text);
    const typed = [t, ...others].join();
    if (typed === this.sent || !this.cells.some((cell) => cell.isTouched)) return;
    this.sent = typed;
    this.editor.send({ kind: 'set', key: this.key, t, q: others.slice(0, 4), p: others.slice(4) });
  }
}

export class KeyTable {
  readonly element = made('div', { className: 'keys' });
  private readonly body = made('tbody');
  private readonly add = made('button', { type: 'button', className: 'add', onclick: () => this.editor.send({ kind: 'add', t: this.newTime() }) });
  private readonly refusal = made('p', { className: 'refusal', role: 'alert' });
  private readonly note = made('p', { className: 'note' });
  private readonly head = made('tr');
  private rows: Row[] = [];
  private keys: number[][] = [];

  constructor(private readonly editor: Editor) {
    const table = made('table', {}, made('caption', {}, 'Keys'), made('thead', {}, this.head), this.body);
    this.element.append(this.refusal, made('div', { className: 'rows' }, table), this.note, this.add);
  }

  /** Rows stay where they are, so that a cell in which somebody types keeps the focus. */
  show(keys: number[][]): void {
    this.keys = keys;
    this.refusal.textContent = '';
    this.showRows(this.firstRow());
    this.showTime();
  }

  /** Why the last edit was not taken; what was typed stays to be mended. */
  refuse(sentence: string, key: number | undefined): void {
    this.refusal.textContent = sentence;
    this.rows.find((row) => row.key === key)?.refuse();
  }

  showTime(): void {
    this.add.textContent = `Add a key at ${Number(this.newTime().toPrecision(6))} s`;
    const first = this.firstRow();
    const isTyping = this.body.contains(document.activeElement);
    if (!isTyping && Math.abs(first - (this.rows[0]?.key ?? 0)) > mostRows / 4) this.showRows(first);
  }

  /** The moment that is shown; at the end the one after as long a step as that before it. */
  private newTime(): number {
    const [before, last] = [this.keys.at(-2)?.[0], this.keys.at(-1)?.[0] ?? 0];
    const time = this.editor.time();
    return time < last ? time : last + (before === undefined ? 1 : last - before);
  }

  private firstRow(): number {
    const time = this.editor.time();
    const here = this.keys.findLastIndex(([t]) => t <= time);
    return Math.max(0, Math.min(here - mostRows / 2, this.keys.length - mostRows));
  }

  private showRows(first: number): void {
    const shown = this.keys.slice(first, first + mostRows);
    const width = this.keys[0]?.length ?? 0;
    if (this.rows.length !== shown.length || this.rows[0]?.key !== first || this.head.childElementCount !== width + 2) {
      this.rows = shown.map((_, i) => new Row(first + i, width, this.editor));
      this.body.replaceChildren(...this.rows.map(({ element }) => element));
      this.head.replaceChildren(...['key', ...names.slice(0, width)].map((name) => made('th', { scope: 'col' }, units[name] ? `${name} [${units[name]}]` : name)), made('td'));
    }
    shown.forEach((numbers, i) => this.rows[i].show(numbers));
    this.note.textContent = shown.length < this.keys.length ? `Of ${this.keys.length} keys ${shown.length} near the time are shown.` : '';
  }
}
