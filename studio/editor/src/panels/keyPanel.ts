// SPDX-License-Identifier: Apache-2.0
// The chosen key by its numbers.
import { element } from 'orispline-viewer/look/element';
import { ownParameters, type OwnParameter } from '../store/parameters';
import { ordersOf, reachedText } from '../store/reached';
import type { Studio } from '../store/studio';
import { KeyFields } from './keyFields';
import type { NumberField } from './numberField';
import type { Orientations } from './orientation';

export class KeyPanel {
  readonly element = element('div', { className: 'key-panel', attributes: { role: 'group', 'aria-label': 'Key' } });
  private readonly number = element('strong', { className: 'number-of' });
  private readonly reached = element('span', { className: 'reached' });
  private readonly turns = element('span', { className: 'fields' });
  private readonly places = element('span', { className: 'fields' });
  private readonly values = element('span', { className: 'fields' });
  private readonly fields: KeyFields;
  private readonly time: NumberField;
  private orientation: NumberField[] = [];
  private position: NumberField[];
  private shown: number | null = null; // the key whose numbers stand there
  private own: { parameter: OwnParameter; field: NumberField }[] = [];

  constructor(
    private readonly studio: Studio,
    private readonly orientations: Orientations,
  ) {
    const { store } = studio;
    this.fields = new KeyFields(studio, orientations, () => store.current().chosen, (what) => what);
    this.fields.shown = () => this.show();
    this.time = this.fields.time();
    this.position = store.current().document.keys[0]?.p ? this.fields.position() : [];
    this.places.append(...this.position.map(({ element }) => element));
    this.element.append(this.number, this.time.element, orientations.menu(), this.turns, ...(this.position.length > 0 ? [this.places] : []), this.values, this.reached);
    orientations.watch(() => {
      this.orientation = this.fields.orientation();
      this.turns.replaceChildren(...this.orientation.map(({ element }) => element));
      this.show();
    });
    store.subscribe(['document', 'chosen', 'curves'], () => this.show());
  }

  private show(): void {
    const state = this.studio.store.current();
    const { key } = this.fields;
    this.element.classList.toggle('is-empty', !key);
    this.number.textContent = key ? `Key ${state.document.keys.indexOf(key) + 1}` : 'No key is chosen';
    if (!key) return;
    this.makeOwn();
    if (key.id !== this.shown) for (const field of [this.time, ...this.orientation, ...this.position, ...this.own.map(({ field }) => field)]) field.reset();
    this.shown = key.id;
    this.time.show(key.t);
    const numbers = this.orientations.numbersOf(key);
    this.orientation.forEach((field, i) => field.show(numbers[i]));
    this.position.forEach((field, i) => field.show(key.p![i]));
    for (const { parameter, field } of this.own) field.show(this.fields.valueOf(parameter));
    this.reached.textContent = reachedText(ordersOf(state)?.[state.document.keys.indexOf(key)]);
  }

  /** Other methods have other parameters. */
  private makeOwn(): void {
    const parameters = ownParameters(this.studio.store.current().document, this.studio.methods);
    const nameOf = ({ which, info }: OwnParameter) => `${which} ${info.name} ${info.default} ${info.min} ${info.max}`;
    if (parameters.map(nameOf).join() === this.own.map(({ parameter }) => nameOf(parameter)).join()) return;
    this.own = parameters.map((parameter) => ({ parameter, field: this.fields.own(parameter) }));
    this.values.replaceChildren(...this.own.map(({ field }) => field.element));
  }
}
