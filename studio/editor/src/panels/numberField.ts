// SPDX-License-Identifier: Apache-2.0
// A field for a number, with a sentence where what was typed is none. Arrows up and down step it.
import { Cell } from 'orispline-viewer/look/cell';
import { element } from 'orispline-viewer/look/element';
import { notANumber, numberIn } from '../edits/reasons';

export interface FieldOptions {
  label: string; // what is seen
  name?: string; // what is said; else the label
  unit?: string;
  step: number;
  decimals?: number; // that are shown; else six digits are
  /** Takes the number, or says in a sentence why it cannot be. One gesture is one step of the history. */
  taken: (value: number, gesture: object) => string | null;
}

let made = 0; // fields have identifiers for what describes them

export class NumberField {
  readonly element: HTMLElement;
  readonly input: HTMLInputElement;
  private readonly cell: Cell;
  private readonly trouble = element('span', { className: 'trouble', attributes: { role: 'alert' } });
  private value = NaN;
  private gesture: object = {};
  private isTaking = false;

  constructor(private readonly options: FieldOptions) {
    const { name, label, decimals } = options;
    this.cell = new Cell(name ?? label, decimals === undefined ? undefined : (value) => String(Number(value.toFixed(decimals)) + 0));
    this.input = this.cell.input;
    this.input.className = 'number';
    this.trouble.id = `orispline-trouble-${++made}`;
    this.trouble.hidden = true;
    this.element = element(
      'span',
      { className: 'field' },
      element('span', { className: 'label', attributes: { 'aria-hidden': 'true' } }, options.label),
      this.input,
      ...(options.unit ? [element('small', { attributes: { 'aria-hidden': 'true' } }, options.unit)] : []),
      this.trouble,
    );
    this.input.addEventListener('change', () => this.commit());
    this.input.addEventListener('keydown', (event) => this.hear(event));
  }

  /** What was typed and refused stays, unless the value is another one. */
  show(value: number): void {
    if (Object.is(value, this.value) && !this.trouble.hidden) return;
    this.value = value;
    if (!this.isTaking && document.activeElement === this.input && this.cell.isTouched && this.trouble.hidden) return; // somebody types
    this.cell.show(value);
    this.refuse(null);
  }

  /** The value again, whatever was typed. */
  reset(): void {
    this.cell.show(this.value);
    this.refuse(null);
  }

  refuse(sentence: string | null): void {
    this.trouble.textContent = sentence ?? '';
    this.trouble.hidden = !sentence;
    this.element.classList.toggle('refused', !!sentence);
    if (sentence) this.input.setAttribute('aria-describedby', this.trouble.id);
    else this.input.removeAttribute('aria-describedby');
    this.input.setAttribute('aria-invalid', String(!!sentence));
  }

  private take(value: number, gesture: object): void {
    this.isTaking = true;
    const sentence = this.options.taken(value, gesture);
    this.isTaking = false;
    if (sentence) this.refuse(sentence);
    else this.reset();
  }

  private commit(): void {
    if (!this.cell.isTouched) return this.reset();
    const value = numberIn(this.input.value);
    if (value === null) this.refuse(notANumber(this.input.value));
    else this.take(value, {});
  }

  private hear(event: KeyboardEvent): void {
    const { key, shiftKey, ctrlKey } = event;
    if (key === 'Escape') this.reset();
    else if (key === 'ArrowUp' || key === 'ArrowDown') {
      event.preventDefault();
      if (!event.repeat) this.gesture = {};
      const typed = numberIn(this.input.value);
      const from = this.cell.isTouched && typed !== null ? typed : this.value;
      const step = this.options.step * (shiftKey ? 10 : ctrlKey ? 0.1 : 1) * (key === 'ArrowUp' ? 1 : -1);
      this.take(Number((from + step).toPrecision(12)), this.gesture);
    }
  }
}
