// SPDX-License-Identifier: Apache-2.0
// One value of a parameter for all keys, such as the tension.
import { element } from 'orispline-viewer/look/element';
import { chosen as written } from 'orispline-viewer/look/number';
import { hasOwn, valueAt, valueForAll, withValueForAll } from '../edits/parameters';
import { meaningOf } from '../store/meanings';
import type { OwnParameter } from '../store/parameters';
import type { Studio } from '../store/studio';

const steps = 100; // of the slider
const moving = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End']; // it
const mostOfDefault = 2;

export class AllKeys {
  readonly element = element('label', { className: 'choice all-keys rare' });
  private readonly slider = element('input', { type: 'range' });
  private readonly value = element('output', {});
  private parameter: OwnParameter | null = null;
  private gesture = {};

  constructor(private readonly studio: Studio) {
    this.element.append(element('span', {}, 'All keys'), this.slider, this.value);
    this.slider.addEventListener('input', () => this.set());
    this.slider.addEventListener('change', () => (this.gesture = {}));
    this.slider.addEventListener('keydown', (event) => moving.includes(event.key) && event.stopPropagation()); // elsewhere they step the time
    studio.store.subscribe(['document'], () => this.show());
  }

  choose(parameter: OwnParameter | null): void {
    this.parameter = parameter;
    this.element.hidden = !parameter;
    if (!parameter) return;
    const { default: usual, min, max, name } = parameter.info;
    const high = Math.min(max, Math.max(mostOfDefault * usual, 1));
    const low = Math.max(min, usual === 0 ? -high : 0);
    Object.assign(this.slider, { min: String(low), max: String(high), step: String((high - low) / steps) });
    this.slider.setAttribute('aria-label', `All keys: ${name}`);
    this.element.title = meaningOf(this.studio.store.current().document[parameter.which].method, parameter.info);
    this.show();
  }

  private show(): void {
    if (!this.parameter) return;
    const { which, info } = this.parameter;
    const { document } = this.studio.store.current();
    const values = hasOwn(document, info.name) ? document.keys.map((key) => valueAt(document, key, which, info)) : [valueForAll(document, which, info)];
    const isOne = values.every((value) => value === values[0]);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    this.slider.value = String(mean);
    this.value.textContent = isOne ? written(values[0]) : 'various';
    this.slider.setAttribute('aria-valuetext', this.value.textContent);
  }

  private set(): void {
    if (!this.parameter) return;
    const { store } = this.studio;
    const { which, info } = this.parameter;
    store.edit(withValueForAll(store.current().document, which, info, Number(Number(this.slider.value).toPrecision(6))), this.gesture);
  }
}
