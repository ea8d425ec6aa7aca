// SPDX-License-Identifier: Apache-2.0
// A parameter at each key, such as its tension, as bars that are pulled up and down.
import { element } from 'orispline-viewer/look/element';
import { chosen as written } from 'orispline-viewer/look/number';
import type { Key } from '../document/document';
import { valueAt, withOwn } from '../edits/parameters';
import { meaningOf } from '../store/meanings';
import type { OwnParameter } from '../store/parameters';
import type { Studio } from '../store/studio';
import { drags } from './drag';
import { reachFor, stride, type Dots } from './dots';
import { nearest, reachOf, stepOf } from './scale';
import { Tip } from './tip';
import type { Track } from './track';

const height = 44; // [px]
const digits = 3;

export class Bars {
  readonly element = element('div', { className: 'bars' });
  private readonly bars = new Map<number, HTMLElement>(); // by the id of the key
  private parameter: OwnParameter | null = null;
  private reach = { low: 0, high: 1 };
  private isPulled = false; // the reach stays meanwhile
  private gesture = {};
  private readonly tip = new Tip();
  private told: number | null = null; // the key of whose bar the tip tells

  constructor(
    private readonly studio: Studio,
    private readonly track: Track,
    private readonly dots: Dots,
  ) {
    track.watch(() => this.show());
    studio.store.subscribe(['document', 'chosen'], () => this.show());
    drags(this.element, (event) => this.grasp(event));
    this.element.addEventListener('keydown', (event) => this.hear(event));
    this.element.append(this.tip.element);
    this.element.addEventListener('pointerover', (event) => this.explain(this.keyOf(event.target)));
    this.element.addEventListener('focusin', (event) => this.explain(this.keyOf(event.target)));
    for (const type of ['pointerleave', 'focusout']) this.element.addEventListener(type, () => !this.isPulled && this.explain(null));
  }

  private keyOf = (target: EventTarget | null): number | null => [...this.bars].find(([, bar]) => bar.contains(target as Node))?.[0] ?? null;

  /** Of whose bar the tip tells what it does; null: of none. */
  private explain(id: number | null): void {
    const bar = id === null ? undefined : this.bars.get(id);
    this.told = bar ? id : null;
    if (bar && this.parameter) this.tip.show(`${bar.getAttribute('aria-label')}: ${bar.getAttribute('aria-valuetext')}. ${this.meaning}`, bar);
    else this.tip.hide();
  }

  private get meaning(): string {
    const { which, info } = this.parameter!;
    return meaningOf(this.studio.store.current().document[which].method, info);
  }

  choose(parameter: OwnParameter | null): void {
    this.parameter = parameter;
    this.element.replaceChildren(this.tip.element);
    this.bars.clear();
    this.explain(null);
    this.show();
  }

  private valueOf = (key: Key): number => valueAt(this.studio.store.current().document, key, this.parameter!.which, this.parameter!.info);

  private show(): void {
    if (!this.parameter || this.track.scale.width === 0) return;
    const { document, chosen } = this.studio.store.current();
    const { info } = this.parameter;
    if (!this.isPulled) this.reach = reachOf(document.keys.map(this.valueOf), info.default, info);
    const { keys, places } = this.dots.inView;
    const gone = new Set(this.bars.keys());
    keys.forEach((key, i) => {
      gone.delete(key.id);
      this.showBar(key, places[i], key.id === chosen);
    });
    for (const id of gone) {
      this.bars.get(id)!.remove();
      this.bars.delete(id);
    }
    if (this.told !== null) this.explain(this.told);
  }

  private share = (value: number): number => Math.min(Math.max((value - this.reach.low) / (this.reach.high - this.reach.low), 0), 1);

  private showBar(key: Key, x: number, isChosen: boolean): void {
    const { info } = this.parameter!;
    const bar = this.bars.get(key.id) ?? this.make(key);
    const value = this.valueOf(key);
    const [from, to] = [this.share(0), this.share(value)];
    bar.style.transform = `translateX(${x}px)`;
    const fill = bar.firstElementChild as HTMLElement;
    fill.style.bottom = `${Math.min(from, to) * height}px`;
    fill.style.height = `${Math.max(Math.abs(to - from) * height, 2)}px`;
    bar.classList.toggle('is-down', value < 0);
    bar.classList.toggle('is-chosen', isChosen);
    bar.tabIndex = isChosen ? 0 : -1;
    const { keys } = this.studio.store.current().document;
    const label = `${info.name} of key ${keys.indexOf(key) + 1}`;
    const said = { 'aria-label': label, 'aria-description': this.meaning, 'aria-valuetext': written(value), 'aria-valuemin': info.min, 'aria-valuemax': info.max, 'aria-valuenow': value };
    for (const [name, text] of Object.entries(said)) bar.setAttribute(name, String(text));
  }

  private make({ id }: Key): HTMLElement {
    const bar = element('div', { className: 'bar', attributes: { role: 'slider', 'aria-orientation': 'vertical' } }, element('i'));
    bar.addEventListener('focus', () => this.studio.store.choose(id));
    this.bars.set(id, bar);
    this.element.append(bar);
    return bar;
  }

  private set(id: number, value: number, gesture: object): void {
    const { store } = this.studio;
    const { which, info } = this.parameter!;
    store.edit(withOwn(store.current().document, id, which, info, value), gesture);
  }

  private grasp(event: PointerEvent) {
    const { keys, places } = this.dots.inView;
    const found = nearest(places, this.track.placeIn(event), reachFor(event));
    if (found < 0 || !this.parameter) return null;
    const { id } = keys[found];
    const before = this.valueOf(keys[found]);
    this.studio.store.choose(id);
    this.bars.get(id)?.focus();
    const perPixel = (this.reach.high - this.reach.low) / height;
    this.isPulled = true;
    this.explain(id);
    return {
      moved: (_: number, dy: number, gesture: object) => this.set(id, dy === 0 ? before : this.within(Number((before - dy * perPixel).toPrecision(digits)), before), gesture),
      ended: () => {
        this.isPulled = false;
        if (event.pointerType !== 'mouse') this.explain(null);
        this.show();
      },
    };
  }

  /** A pull ends where the bar does; the next one goes farther. */
  private within = (value: number, before: number): number => Math.min(Math.max(value, Math.min(this.reach.low, before)), Math.max(this.reach.high, before));

  private hear(event: KeyboardEvent): void {
    const { document, chosen } = this.studio.store.current();
    const key = document.keys.find(({ id }) => id === chosen);
    const by = { ArrowUp: 1, ArrowDown: -1, ArrowRight: 1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (!key || by === undefined || event.altKey || event.metaKey || !this.parameter) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) this.gesture = {};
    this.set(key.id, Number((this.valueOf(key) + by * stepOf(this.reach) * stride(event)).toFixed(9)), this.gesture);
  }
}
