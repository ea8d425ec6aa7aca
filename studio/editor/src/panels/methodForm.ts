// SPDX-License-Identifier: Apache-2.0
// The settings of a method, made from what the library says of it, so that another method needs no line here.
import { element, menu } from 'orispline-viewer/look/element';
import { angleBetween } from 'orispline-viewer/motion/quaternion';
import { names, type Choice, type Setting, type Which } from '../document/document';
import { clamped, endsOf, isLoop, rateNames, withSetting } from '../edits/choice';
import { hasOwn, valueForAll, withoutOwn, withValueForAll } from '../edits/parameters';
import { notAValue } from '../edits/reasons';
import type { MethodInfo, ParameterInfo } from '../engine/protocol';
import type { Studio } from '../store/studio';
import { NumberField } from './numberField';

const ends = ['Start', 'End'];
const sameAngle = 1e-6; // [rad], [m]: what the library takes for a return
const fineness = 20; // steps of an arrow key up to the default

export class MethodForm {
  readonly element = element('div', { className: 'method-form' });
  private method?: MethodInfo;
  private shows: ((choice: Choice) => void)[] = []; // of what stands in the form

  constructor(
    private readonly studio: Studio,
    private readonly which: Which,
  ) {
    studio.store.subscribe(['document'], () => this.show());
  }

  private get document() {
    return this.studio.store.current().document;
  }

  private show(): void {
    const choice = this.document[this.which];
    const method = this.studio.methods.find(({ name }) => name === choice.method);
    if (method !== this.method) this.make(method);
    for (const show of this.shows) show(choice);
  }

  private make(method: MethodInfo | undefined): void {
    this.method = method;
    this.shows = [];
    if (!method) return;
    const { parameters, choices, closes } = method;
    const lines = [
      ...parameters.map((parameter) => this.parameter(parameter)),
      ...choices.map(({ name, words, default: usual }) => this.words(name, words, usual ?? words[0])),
      ...(method.ends.length > 0 ? [this.ends(method), this.rate(0), this.rate(1)] : []),
      ...(closes ? [this.closed(), this.period()] : []),
    ];
    const none = element('p', { className: 'facts' }, `${method.name} has no settings.`);
    this.element.replaceChildren(element('p', { className: 'about' }, element('strong', {}, `${names[this.which]} ${method.name}`), ` ${method.title}`), ...(lines.length > 0 ? lines : [none]));
  }

  private set(name: string, value: Setting | undefined, gesture?: object): void {
    this.studio.store.edit(withSetting(this.document, this.which, this.method!, name, value), gesture);
  }

  /** Where keys have values of their own, those of all of them. */
  private parameter(info: ParameterInfo): HTMLElement {
    const { name, per_key, default: usual } = info;
    const taken = (value: number, gesture: object) => {
      const why = notAValue(info, value);
      if (why) return why;
      if (per_key) this.studio.store.edit(withValueForAll(this.document, this.which, info, value), gesture);
      else this.set(name, value === usual ? undefined : value, gesture);
      return null;
    };
    const isCount = Number.isInteger(usual) && Number.isInteger(info.min) && info.min > 0; // such as an order or a degree
    const field = new NumberField({ label: name, step: isCount ? 1 : Number((Math.abs(usual) / fineness || 1 / fineness).toPrecision(1)), taken });
    const same = element('button', { type: 'button', className: 'side', onclick: () => this.studio.store.edit(withoutOwn(this.document, name)) }, 'One for all keys');
    const note = element('span', { className: 'own' }, 'Each key has its own. ', same);
    this.shows.push(() => {
      field.show(valueForAll(this.document, this.which, info));
      note.hidden = !hasOwn(this.document, name);
      field.element.hidden = !note.hidden;
    });
    return element('div', { className: 'setting' }, element('span', {}, name), field.element, note);
  }

  private words(name: string, values: string[], usual: string): HTMLElement {
    const [line, select] = menu(name, values.map((value) => [value, value]), (value) => this.set(name, value === usual ? undefined : value));
    this.shows.push(({ settings }) => (select.value = String(settings[name] ?? usual)));
    line.classList.add('setting');
    return line;
  }

  private ends(method: MethodInfo): HTMLElement {
    const rules = method.ends.map((rule): [string, string] => [rule, rule]);
    const set = () => {
      const [start, end] = menus.map(([, { value }]) => value);
      const text = start === end ? start : `${start},${end}`;
      this.set('ends', text === method.ends[0] ? undefined : text);
    };
    const menus = ends.map((name) => menu(name, rules, set));
    const box = element('div', { className: 'ends' }, ...menus.map(([line]) => line));
    for (const [line] of menus) line.classList.add('setting');
    this.shows.push(({ settings }) => {
      const found = typeof settings.ends === 'string' ? endsOf(settings.ends) : [method.ends[0]];
      menus[0][1].value = found[0];
      menus[1][1].value = found[found.length - 1];
      box.hidden = isLoop({ method: method.name, settings });
    });
    return box;
  }

  /** Three numbers, of an end that is clamped. */
  private rate(end: 0 | 1): HTMLElement {
    const name = rateNames[end];
    const now = () => String(this.document[this.which].settings[name] ?? '0,0,0').split(',').map(Number);
    const fields = ['x', 'y', 'z'].map((axis, i) => {
      const taken = (value: number, gesture: object) => {
        this.set(name, now().with(i, value).join(), gesture);
        return null;
      };
      return new NumberField({ label: axis, name: `${ends[end]}: angular velocity about ${axis}, body, rad/s`, step: 0.05, taken });
    });
    const box = element('div', { className: 'setting rate' }, element('span', {}, `ω at the ${ends[end].toLowerCase()}, body [rad/s]`), element('span', { className: 'fields' }, ...fields.map((field) => field.element)));
    this.shows.push((choice) => {
      box.hidden = !clamped(choice)[end];
      now().forEach((value, i) => fields[i].show(value));
    });
    return box;
  }

  private closed(): HTMLElement {
    const set = () => {
      const [isClosed, gesture] = [box.checked, {}];
      this.set('closed', isClosed || undefined, gesture);
      this.set('period', isClosed ? this.periodWanted() : undefined, gesture);
    };
    const box = element('input', { type: 'checkbox', onchange: set });
    this.shows.push((choice) => (box.checked = isLoop(choice)));
    return element('label', { className: 'setting' }, element('span', {}, 'Closed: a loop'), box);
  }

  /** From the first key to its return; none where the last key is the first one again. */
  private periodWanted(): number | undefined {
    const { keys } = this.document;
    const [first, last] = [keys[0], keys[keys.length - 1]];
    const isReturn = (angleBetween([...first.q], [...last.q]) * Math.PI) / 180 < sameAngle && Math.hypot(...(first.p ?? []).map((value, i) => value - last.p![i])) < sameAngle;
    return isReturn ? undefined : Number((((last.t - first.t) * keys.length) / (keys.length - 1)).toPrecision(9));
  }

  private period(): HTMLElement {
    const span = () => this.document.keys[this.document.keys.length - 1].t - this.document.keys[0].t;
    const taken = (value: number, gesture: object) => {
      if (value < span()) return `Found a period of ${value} s, wanted one that ends after the last key, ${span()} s or more. Give a longer one.`;
      this.set('period', value, gesture);
      return null;
    };
    const field = new NumberField({ label: 'Period', name: 'Period, s', unit: 's', step: 0.1, decimals: 6, taken });
    const line = element('div', { className: 'setting' }, element('span', {}, 'Period, from the first key to its return'), field.element);
    this.shows.push((choice) => {
      line.hidden = !isLoop(choice);
      field.show(typeof choice.settings.period === 'number' ? choice.settings.period : span());
    });
    return line;
  }
}
