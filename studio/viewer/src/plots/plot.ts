// SPDX-License-Identifier: Apache-2.0
// One plot over time. Its cursor follows the time of the viewer, and moves it.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Numbers } from '../data/numbers';
import { element } from '../look/element';
import { chosen, shown, tick } from '../look/number';
import { coloursOf, type Colours } from '../look/theme';
import { spanAt } from '../motion/orientation';
import type { Line, PlacedBand, Points, Quantity } from '../quantities/quantity';
import type { State, Store } from '../store/store';
import { aligned } from './aligned';
import { drawBand, drawLimit, drawMarks, markKeys } from './drawings';

const height = 190;
const font = '12px system-ui, sans-serif';
const rounding = 1e-12; // of 1, or of the largest value: what is smaller is 0

/** Of all values and one more. */
function largest(lists: Numbers[], least: number): number {
  let size = least;
  for (const values of lists) for (const value of values) if (Math.abs(value) > size) size = Math.abs(value);
  return size;
}

/** With 0, and a range where all is 0 too. */
const rangeOf = (low: number, high: number) => uPlot.rangeNum(low < -rounding ? low : 0, high > rounding || low < -rounding ? Math.max(high, 0) : 1, 0.06, true);

interface Beside {
  ready: () => void;
  keys: Numbers;
  limit?: number;
  marks?: Points;
  band?: PlacedBand;
}

function chooseWindow({ scales: { x } }: uPlot, { current, choose }: Store): void {
  const [from, to] = current().window;
  if (x.min !== undefined && x.max !== undefined && (x.min !== from || x.max !== to)) choose({ window: [x.min, x.max] });
}

function optionsOf(store: Store, lines: Line[], { ready, keys, limit, marks, band }: Beside, width: number, colours: Colours): uPlot.Options {
  const { current, moveTo, moments } = store;
  const reach = largest(band ? [band.high] : [], limit ?? 0);
  const axis = { stroke: colours.faint, font, ticks: { stroke: colours.grid, size: 4 } };
  return {
    width,
    height,
    padding: [10, 12, 0, 0],
    legend: { show: false },
    scales: { x: { time: false }, y: { range: (_, low, high) => rangeOf(low ?? 0, Math.max(high ?? 0, reach)) } },
    axes: [
      { ...axis, grid: { show: false }, size: 28, values: (_, ticks) => moments.ticks(ticks) },
      { ...axis, grid: { stroke: colours.grid, width: 1 }, size: 52, values: (_, ticks) => ticks.map(tick) },
    ],
    series: [{}, ...lines.map(({ label, colour, width, dashes }) => ({ label, stroke: colour, width, dash: dashes, spanGaps: false, points: { show: false } }))],
    cursor: { y: false, points: { size: 7 }, drag: { x: true, y: false, setScale: true }, bind: { mouseleave: () => null } },
    hooks: {
      ready: [ready],
      drawClear: [(plot) => markKeys(plot, keys, colours), (plot) => band && drawBand(plot, band, colours)],
      draw: [(plot) => limit !== undefined && drawLimit(plot, limit, colours), (plot) => marks && drawMarks(plot, marks, colours)],
      setCursor: [(plot) => plot.cursor.event && !current().playing && moveTo(plot.posToVal(plot.cursor.left!, 'x'))],
      setScale: [(plot, key) => key === 'x' && chooseWindow(plot, store)],
    },
  };
}

/** A finger moves the time along, and the page up and down. */
function followFinger(plot: uPlot, moveTo: Store['moveTo']): void {
  const move = (event: PointerEvent) => {
    if (event.pointerType === 'mouse') return;
    moveTo(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  };
  plot.over.addEventListener('pointerdown', move);
  plot.over.addEventListener('pointermove', move);
  plot.over.addEventListener('click', (event) => moveTo(plot.posToVal(event.offsetX, 'x')));
}

export class Plot {
  private readonly caption = element('figcaption');
  private readonly frame = element('div', { className: 'frame' });
  private readonly figure: HTMLElement;
  private plot?: uPlot;
  private lines: Line[] = [];
  private rounding = 0;
  private band?: PlacedBand;

  constructor(
    private readonly store: Store,
    place: HTMLElement,
    private readonly quantity: Quantity,
  ) {
    this.figure = element('figure', { attributes: { 'data-quantity': quantity.id } }, this.caption, this.frame);
    place.append(this.figure); // its width is to be known
    store.watchSize(this.frame, () => this.plot?.setSize({ width: this.frame.clientWidth, height }));
    store.atEnd(() => this.plot?.destroy());
  }

  rebuild(state: State): void {
    this.plot?.destroy();
    const colours = coloursOf(state);
    this.lines = this.quantity.lines(state, colours);
    this.figure.hidden = this.lines.length === 0;
    this.rounding = rounding * largest(
      this.lines.map(({ values }) => values),
      1,
    );
    const { limit, marks } = this.quantity;
    const keys = this.quantity.keys(state);
    this.band = this.quantity.band?.(state);
    const ready = () => this.plot && this.showTime(this.store.current()); // before that, places in the plot are not known
    const options = optionsOf(this.store, this.lines, { ready, keys, limit, marks, band: this.band }, this.frame.clientWidth, colours);
    this.plot = new uPlot(options, aligned(this.lines, state.extent), this.frame);
    followFinger(this.plot, this.store.moveTo);
    this.showWindow(state);
    this.showTime(state);
  }

  showWindow({ window: [min, max] }: State): void {
    this.plot?.setScale('x', { min, max });
  }

  showTime({ time }: State): void {
    const plot = this.plot!;
    if (!plot.cursor.event || plot.posToVal(plot.cursor.left!, 'x') !== time)
      plot.setCursor({ left: plot.valToPos(time, 'x'), top: 1 }, false);
    const values = this.lines.map(({ label, colour, t, values }) => {
      const i = spanAt(t, time);
      const nearest = t[i + 1] - time < time - t[i] ? i + 1 : i;
      const swatch = element('i');
      swatch.style.background = colour;
      return element('span', {}, swatch, `${label} `, element('b', {}, shown(values[nearest], this.rounding)));
    });
    const unit = this.quantity.unit ? [element('small', {}, ` [${this.quantity.unit}] `)] : [];
    this.caption.replaceChildren(element('strong', {}, this.quantity.title), ...unit, ...values, ...this.legend(coloursOf(this.store.current())));
  }

  /** What is drawn beside the lines. */
  private legend(colours: Colours): HTMLElement[] {
    const sign = (text: string, colour: string) => {
      const made = element('em', {}, text);
      made.style.color = colour;
      return made;
    };
    const { limit, limitLabel = 'limit', marks } = this.quantity;
    return [
      ...(limit !== undefined ? [element('span', {}, sign('╌╌', colours.limit), ` ${limitLabel} `, element('b', {}, chosen(limit)))] : []),
      ...(this.band ? [element('span', {}, sign('▮', colours[this.band.place]), ` ${this.band.label}`)] : []),
      ...(marks ? [element('span', {}, sign('×', colours.mark), ` ${marks.label}`)] : []),
    ];
  }
}
