// SPDX-License-Identifier: Apache-2.0
// The form in which orientations are written, which is the same everywhere, and the numbers of a key in it.
import { element } from 'orispline-viewer/look/element';
import type { Key, Quaternion } from '../document/document';
import { formNamed, groups, type Form } from './forms';

const usual = 'ZYX';

/** What was typed stays as it was, where the orientation has other numbers too, such as angles beyond half a turn. */
interface Typed {
  q: Quaternion;
  form: Form;
  numbers: number[];
}

export class Orientations {
  private form = formNamed(usual);
  private readonly typed = new Map<number, Typed>(); // by the id of the key
  private readonly watchers: (() => void)[] = [];

  get current(): Form {
    return this.form;
  }

  /** Calls the update now, and when another form is chosen. */
  watch(update: () => void): void {
    this.watchers.push(update);
    update();
  }

  numbersOf({ id, q }: Key): number[] {
    const typed = this.typed.get(id);
    return typed && typed.form === this.form && typed.q.every((value, i) => value === q[i]) ? typed.numbers : this.form.numbersOf(q);
  }

  /** What was typed has made the key. */
  keep({ id, q }: Key, numbers: number[]): void {
    this.typed.set(id, { q, form: this.form, numbers });
  }

  menu(): HTMLElement {
    const options = groups.map(([label, forms]) => element('optgroup', { label }, ...forms.map(({ id, title }) => element('option', { value: id }, title))));
    const select = element('select', { className: 'rare', attributes: { 'aria-label': 'Orientation as' }, onchange: () => this.choose(select.value) }, ...options);
    this.watch(() => (select.value = this.form.id));
    return select;
  }

  private choose(id: string): void {
    this.form = formNamed(id);
    for (const update of this.watchers) update();
  }
}
