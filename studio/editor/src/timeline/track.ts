// SPDX-License-Identifier: Apache-2.0
// The stretch of time that is shown, with its marks and the cursor: dragged it moves the time, wheel and pinch zoom and pan.
import { element } from 'orispline-viewer/look/element';
import type { Studio } from '../store/studio';
import type { Drag } from './drag';
import { marks, perPixel, placeOf, slid, timeAt, zoomed, type Scale } from './scale';

const wheelStep = 1 / 400; // of a notch of 100 px
const namespace = 'http://www.w3.org/2000/svg';

export const svg = (tag: string, attributes: Record<string, string | number>, text = ''): SVGElement => {
  const made = document.createElementNS(namespace, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text;
  return made;
};

export class Track {
  readonly element = element('div', { className: 'track' });
  readonly ruler = element('div', { className: 'ruler', title: 'Drag to move the time' });
  private readonly cursor = element('div', { className: 'cursor' });
  private readonly lines = svg('svg', { 'aria-hidden': 'true' });
  private width = 0;
  private readonly watchers: (() => void)[] = [];

  constructor(private readonly studio: Studio) {
    const { view } = studio;
    this.ruler.append(this.lines);
    this.element.append(this.ruler, this.cursor);
    view.watchSize(this.element, () => {
      this.width = this.element.clientWidth;
      this.tell();
    });
    view.subscribe(['window', 'extent'], () => this.tell());
    view.subscribe(['time'], () => this.showTime());
    this.scrub();
    this.element.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  get scale(): Scale {
    const [from, to] = this.studio.view.current().window;
    return { from, to, width: this.width };
  }

  /** Calls the update when places change. */
  watch(update: () => void): void {
    this.watchers.push(update);
  }

  /** Where an event is on the track [px]. */
  placeIn = ({ clientX }: { clientX: number }): number => clientX - this.element.getBoundingClientRect().left;

  zoom(factor: number, around = this.studio.view.current().time): void {
    const { choose, current } = this.studio.view;
    const { window, extent } = current();
    choose({ window: zoomed(window, extent, around, factor) });
  }

  pan(by: number): void {
    const { choose, current } = this.studio.view;
    const { window, extent } = current();
    choose({ window: slid(window, extent, by) });
  }

  /** Pulls what is shown along. */
  grasp(): Drag {
    const { scale } = this;
    const { choose, current } = this.studio.view;
    return { moved: (dx) => choose({ window: slid([scale.from, scale.to], current().extent, -dx * perPixel(scale)) }) };
  }

  private tell(): void {
    if (this.width === 0) return;
    this.drawMarks();
    this.showTime();
    for (const update of this.watchers) update();
  }

  private drawMarks(): void {
    const { scale } = this;
    const times = marks(scale);
    const texts = this.studio.view.moments.ticks(times);
    const drawn = times.flatMap((time, i) => {
      const x = placeOf(scale, time);
      return [svg('line', { x1: x, x2: x, y1: 16, y2: 22 }), svg('text', { x, y: 12 }, texts[i])];
    });
    this.lines.replaceChildren(...drawn);
  }

  private showTime(): void {
    const x = placeOf(this.scale, this.studio.view.current().time);
    this.cursor.hidden = x < 0 || x > this.width;
    this.cursor.style.transform = `translateX(${x}px)`;
  }

  private scrub(): void {
    const { view } = this.studio;
    const move = (event: PointerEvent) => view.moveTo(timeAt(this.scale, this.placeIn(event)));
    this.ruler.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.ruler.setPointerCapture(event.pointerId);
      move(event);
    });
    this.ruler.addEventListener('pointermove', (event) => this.ruler.hasPointerCapture(event.pointerId) && move(event));
  }

  /** With Ctrl, as of a pinch on a touchpad, it zooms; sideways it pans. */
  private wheel(event: WheelEvent): void {
    const { deltaX, deltaY, ctrlKey, metaKey, shiftKey } = event;
    const { scale } = this;
    if (ctrlKey || metaKey) this.zoom(2 ** (deltaY * wheelStep), timeAt(scale, this.placeIn(event)));
    else if (shiftKey || Math.abs(deltaX) > Math.abs(deltaY)) this.pan(((deltaX || deltaY) * (scale.to - scale.from)) / Math.max(scale.width, 1));
    else return;
    event.preventDefault();
  }
}
