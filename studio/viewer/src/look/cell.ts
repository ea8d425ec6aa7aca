// SPDX-License-Identifier: Apache-2.0
// A number that can be typed. It is shown with few digits; one that was not touched keeps all of them.

const shownDigits = 6;
const short = (value: number) => String(Number(value.toPrecision(shownDigits)));

export class Cell {
  readonly input = document.createElement('input');
  private value = NaN;

  /** `written`: how a value is shown. */
  constructor(
    label: string,
    private readonly written: (value: number) => string = short,
  ) {
    this.input.inputMode = 'decimal';
    this.input.autocomplete = 'off';
    this.input.spellcheck = false;
    this.input.setAttribute('aria-label', label);
  }

  get isTouched(): boolean {
    return this.input.value !== this.written(this.value);
  }

  /** What was typed, else all digits. */
  get text(): string {
    return this.isTouched ? this.input.value.trim() : String(this.value);
  }

  show(value: number): void {
    this.value = value;
    this.reset();
  }

  reset(): void {
    this.input.value = this.written(this.value);
    this.input.title = String(this.value);
  }
}
