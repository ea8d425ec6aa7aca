// SPDX-License-Identifier: Apache-2.0
// The keys at their times: full where the curve is smooth, hollow where velocity or acceleration jumps.
import { element } from 'orispline-viewer/look/element';
import { closestKeys } from 'orispline-viewer/plots/drawings';
import type { Key } from '../document/document';
import { timesFor, timesForDrag, type Range } from '../edits/time';
import { findingsIn } from '../store/findings';
import { jumps, ordersOf, reachedText } from '../store/reached';
import type { Studio } from '../store/studio';
import type { Actions } from './actions';
import { drags } from './drag';
import { apart, nearest, perPixel, placeOf, roundTime } from './scale';
import { svg, type Track } from './track';

const reach = { mouse: 14, touch: 22 }; // [px]
const onKey = 8; // [px]
const mark = 20; // [px] from a key to the next one at least, so that both are seen whole
const nearStep = 0.01; // of the window

export const reachFor = ({ pointerType }: PointerEvent): number => (pointerType === 'mouse' ? reach.mouse : reach.touch);

/** An arrow key with Shift goes ten times as far, with Ctrl a tenth. */
export const stride = ({ shiftKey, ctrlKey }: KeyboardEvent): number => (shiftKey ? 10 : ctrlKey ? 0.1 : 1);

export class Dots {
  readonly element = element('div', { className: 'dots' });
  private readonly ticks = svg('svg', { 'aria-hidden': 'true' });
  private readonly stops = element('div', { className: 'stops', hidden: true }); // between which a key may be dragged
  private readonly dots = new Map<number, HTMLElement>(); // by the id of the key
  private shown: Key[] = [];
  private places: number[] = [];
  private gesture = {};

  constructor(
    private readonly studio: Studio,
    private readonly track: Track,
    private readonly actions: Actions,
  ) {
    this.element.append(this.ticks, this.stops);
    track.watch(() => this.show());
    studio.store.subscribe(['document', 'chosen', 'curves'], () => this.show());
    drags(this.element, (event) => this.grasp(event));
    this.element.addEventListener('keydown', (event) => this.hear(event));
  }

  /** The keys that are seen, from left to right, and where they are [px]. */
  get inView(): { keys: Key[]; places: number[] } {
    return { keys: this.shown, places: this.places };
  }

  /** Whether there is a key at a place [px]. */
  isAt = (x: number): boolean => nearest(this.places, x, onKey) >= 0;

  focus(): void {
    const { chosen } = this.studio.store.current();
    if (chosen !== null) this.dots.get(chosen)?.focus();
  }

  private show(): void {
    const { scale } = this.track;
    if (scale.width === 0) return;
    const state = this.studio.store.current();
    const { keys } = state.document;
    const near = keys.map((key, index) => ({ key, index, x: placeOf(scale, key.t) })).filter(({ key, x }) => (x >= 0 && x <= scale.width) || key.id === state.chosen);
    this.ticks.replaceChildren(...this.spunSpans(), svg('path', { d: near.map(({ x }) => `M${x.toFixed(1)} 0v4`).join('') }));
    const kept = apart(near.map(({ x }) => x), closestKeys, near.findIndex(({ key }) => key.id === state.chosen)).map((i) => near[i]);
    this.shown = kept.map(({ key }) => key);
    this.places = kept.map(({ x }) => x);
    const orders = ordersOf(state);
    const gone = new Set(this.dots.keys());
    for (const { key, index, x } of kept) {
      gone.delete(key.id);
      this.showDot(key, index, x, orders?.[index], key.id === state.chosen);
    }
    for (const id of gone) {
      this.dots.get(id)!.remove();
      this.dots.delete(id);
    }
  }

  /** Where the curve turns much farther than its keys. */
  private spunSpans(): SVGElement[] {
    const { store, methods } = this.studio;
    const found = findingsIn(store.current(), methods);
    const { scale } = this.track;
    return (found?.spun ?? []).map((i) => {
      const [x, to] = [placeOf(scale, found!.keys[i].t), placeOf(scale, found!.keys[i + 1].t)];
      return svg('rect', { class: 'spun', x, y: 0, width: to - x, height: 30 });
    });
  }

  private showDot(key: Key, index: number, x: number, order: number | undefined, isChosen: boolean): void {
    const dot = this.dots.get(key.id) ?? this.make(key);
    const reached = reachedText(order);
    const text = [this.studio.view.moments.text(key.t), reached].filter(Boolean).join(', ');
    dot.style.transform = `translateX(${x}px)`;
    dot.classList.toggle('jumps', jumps(order));
    dot.classList.toggle('is-chosen', isChosen);
    dot.tabIndex = isChosen ? 0 : -1;
    dot.title = `Key ${index + 1}: ${text}`;
    const { min, max } = isChosen ? timesFor(this.studio.store.current().document, key.id) : { min: key.t, max: key.t };
    const said = { 'aria-label': `Key ${index + 1}`, 'aria-valuetext': text, 'aria-valuemin': min, 'aria-valuemax': max, 'aria-valuenow': key.t };
    for (const [name, value] of Object.entries(said)) dot.setAttribute(name, String(value));
  }

  private make({ id }: Key): HTMLElement {
    const dot = element('div', { className: 'dot', attributes: { role: 'slider' } }, element('i'));
    dot.addEventListener('focus', () => this.studio.store.choose(id));
    dot.addEventListener('click', () => this.studio.store.choose(id));
    this.dots.set(id, dot);
    this.element.append(dot);
    return dot;
  }

  /** A key, or where there is none the stretch of time that is shown. */
  private grasp(event: PointerEvent) {
    const found = nearest(this.places, this.track.placeIn(event), reachFor(event));
    if (found < 0) return this.track.grasp();
    const { id, t } = this.shown[found];
    this.studio.store.choose(id);
    this.focus();
    const { scale } = this.track; // as it is now: an end that is dragged changes it
    const moved = (dx: number, _: number, gesture: object) => {
      const wanted = dx === 0 ? t : roundTime(scale, t + dx * perPixel(scale));
      const time = dx === 0 ? t : this.beside(id, wanted);
      this.actions.move(id, time, gesture);
      this.showStops(id, time !== wanted);
    };
    return { moved, ended: () => (this.stops.hidden = true) };
  }

  /** Off the neighbours, for nobody means to hide a key behind another one. Numbers can be typed. */
  private beside(id: number, time: number): number {
    const { min, max } = this.stopsOf(id);
    return Number(Math.min(Math.max(time, min), max).toPrecision(15));
  }

  private stopsOf = (id: number): Range => timesForDrag(this.studio.store.current().document, id, mark * perPixel(this.track.scale));

  /** What a key is dragged between; `isHeld`: it does not follow the pointer. */
  private showStops(id: number, isHeld: boolean): void {
    const { scale } = this.track;
    const [from, to] = Object.values(this.stopsOf(id)).map((time) => Math.min(Math.max(placeOf(scale, time), 0), scale.width));
    this.stops.hidden = false;
    this.stops.classList.toggle('is-held', isHeld);
    this.stops.style.left = `${from}px`;
    this.stops.style.width = `${Math.max(to - from, 0)}px`;
  }

  private hear(event: KeyboardEvent): void {
    const { key } = event;
    const { chosen } = this.actions;
    if (!chosen || event.altKey || event.metaKey || !(event.target as Element).matches('.dot')) return;
    const sideways = { ArrowLeft: -1, ArrowRight: 1 }[key];
    const along = { ArrowUp: -1, ArrowDown: 1, PageUp: -10, PageDown: 10, Home: -Infinity, End: Infinity }[key];
    if (sideways === undefined && along === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (along !== undefined) {
      this.actions.step(along);
      return this.focus();
    }
    if (!event.repeat) this.gesture = {};
    const { from, to } = this.track.scale;
    this.actions.move(chosen.id, this.beside(chosen.id, Number((chosen.t + sideways! * nearStep * stride(event) * (to - from)).toPrecision(15))), this.gesture);
  }
}
