// SPDX-License-Identifier: Apache-2.0
// One plot over time. Its cursor follows the time of the viewer, and moves it.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Numbers } from '../data/numbers';
import { element } from '../look/element';
import { chosen, shown, tick } from '../look/number';
import type { Colours } from '../look/theme';
import type { Course, Line, PlacedBand, Quantity } from '../quantities/quantity';
import type { State, Store } from '../store/store';
import { aligned } from './aligned';
import { drawBand, drawFlags, drawLimit, drawMarks, markKeys } from './drawings';
import { rangeOf, shownOf, type Cut } from './range';
import type { Turns } from './turns';

const usualHeight = 190; // [px], where the style says none
const font = '12px system-ui, sans-serif';
const rounding = 1e-12; // of 1, or of the largest value: what is smaller is 0

/** Of all values and one more. */
function largest(lists: Numbers[], least: number): number {
  let size = least;
  for (const values of lists) for (const value of values) if (Math.abs(value) > size) size = Math.abs(value);
  return size;
}

function chooseWindow({ scales: { x } }: uPlot, { current, choose }: Store): void {
  const [from, to] = current().window;
  if (x.min !== undefined && x.max !== undefined && (x.min !== from || x.max !== to)) choose({ window: [x.min, x.max] });
}

/** NaN is not. */
const isWithin = ({ min = NaN, max = NaN }: uPlot.Scale, value: number): boolean => value >= min && value <= max;

/** What a plot draws besides its lines, as it is at the moment. */
interface Drawn {
  lines: Line[];
  keys: Numbers;
  band?: PlacedBand;
  colours: Colours;
}

/** Of what some are not drawn, since they are too near to each other. */
export interface Thinned {
  keys: boolean;
  marks: boolean;
}

interface Size {
  width: number;
  height: number;
}

interface Hooks {
  ready: () => void;
  range: () => uPlot.Range.MinMax;
  drawn: () => Drawn;
  placed: () => void; // lines and scales are others
  thinned: (what: keyof Thinned, is: boolean) => void;
}

function optionsOf(store: Store, { limit, marks, flags }: Quantity, { ready, range, drawn, placed, thinned }: Hooks, { width, height }: Size): uPlot.Options {
  const { current, moveTo } = store;
  const { lines, colours } = drawn();
  const axis = { stroke: colours.faint, font, ticks: { stroke: colours.grid, size: 4 } };
  const before = (plot: uPlot) => {
    const { keys, band } = drawn();
    thinned('keys', markKeys(plot, keys, colours));
    if (band) drawBand(plot, band, colours);
    if (flags) drawFlags(plot, flags(), colours);
  };
  return {
    width,
    height,
    padding: [10, 24, 0, 0], // at the right half of the name of a moment
    legend: { show: false },
    scales: { x: { time: false }, y: { range } },
    axes: [
      { ...axis, grid: { show: false }, size: 28, values: (_, ticks) => store.moments.ticks(ticks) },
      { ...axis, grid: { stroke: colours.grid, width: 1 }, size: 52, values: (_, ticks) => ticks.map(tick) },
    ],
    series: [{}, ...lines.map(({ label, colour, width, dashes }) => ({ label, stroke: colour, width, dash: dashes, spanGaps: false, points: { show: false } }))],
    cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: true }, bind: { mouseleave: () => null } },
    hooks: {
      ready: [ready],
      drawClear: [before],
      draw: [placed, (plot) => limit !== undefined && drawLimit(plot, limit, colours), (plot) => marks && thinned('marks', drawMarks(plot, marks, colours))],
      setCursor: [(plot) => plot.cursor.event && !current().playing && moveTo(plot.posToVal(plot.cursor.left!, 'x'))],
      setScale: [(plot, key) => key === 'x' && chooseWindow(plot, store)],
    },
  };
}

/** What two sets of lines have to share so that one plot can draw both. */
const lookOf = ({ lines, colours }: Drawn) => JSON.stringify([colours.ground, ...lines.map(({ colour, width, dashes }) => [colour, width, dashes])]);

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

/** A line as it is drawn. */
export interface Plotted extends Course {
  label: string;
}

export class Plot {
  readonly figure: HTMLElement;
  private readonly caption = element('figcaption');
  private readonly frame = element('div', { className: 'frame' });
  private plot?: uPlot;
  private look = '';
  private drawn: Drawn;
  private cuts: Cut[] = [];
  private rounding = rounding;
  private values: HTMLElement[] = []; // of each line, beside its name
  private dots: HTMLElement[] = []; // of each line, on it
  private readonly cut = element('span', { className: 'cut' });
  readonly thinned: Thinned = { keys: false, marks: false };

  constructor(
    private readonly store: Store,
    place: HTMLElement,
    private readonly quantity: Quantity,
    private readonly turns: Turns,
    private readonly told: () => void, // of what is left out
  ) {
    this.drawn = this.drawnIn(store.current());
    this.figure = element('figure', { attributes: { 'data-quantity': quantity.id } }, this.caption, this.frame);
    place.append(this.figure); // its width is to be known
    turns.add(this);
    store.watchSize(this.frame, () => this.plot?.setSize(this.size));
    store.atEnd(() => this.plot?.destroy());
  }

  get id(): string {
    return this.quantity.id;
  }

  private get size(): Size {
    const { clientWidth, clientHeight } = this.frame;
    return { width: clientWidth, height: clientHeight || usualHeight };
  }

  /** For tests, and for those who want the numbers. */
  get plotted(): Plotted[] {
    return this.drawn.lines.map(({ label, course }) => ({ label, ...course() }));
  }

  private drawnIn(state: State): Drawn {
    const colours = this.store.colours(state);
    return { lines: this.quantity.lines(state, colours), keys: this.quantity.keys(state), band: this.quantity.band?.(state), colours };
  }

  /** What is written stands there at once; what is drawn waits for its turn. */
  rebuild(state: State): void {
    this.drawn = this.drawnIn(state);
    this.figure.hidden = this.drawn.lines.length === 0;
    this.cuts = [];
    this.write();
    this.turns.ask(this);
  }

  /** Where the lines look as those before, the plot stays and draws them. */
  draw(): void {
    const state = this.store.current();
    const { lines } = this.drawn;
    const courses = lines.map(({ course }) => course());
    this.rounding = rounding * largest(
      courses.map(({ values }) => values),
      1,
    );
    const data = aligned(courses, state.extent);
    const look = lookOf(this.drawn);
    if (this.plot && look === this.look) this.plot.setData(data, false);
    else this.replace(data);
    this.look = look;
    this.scale(state);
    this.showTime(state);
  }

  private replace(data: uPlot.AlignedData): void {
    this.plot?.destroy();
    const hooks: Hooks = {
      ready: () => this.plot && this.showTime(this.store.current()), // before that, places in the plot are not known
      range: () => this.range(),
      drawn: () => this.drawn,
      placed: () => this.placeDots(),
      thinned: (what, is) => {
        this.thinned[what] = is;
        this.told();
      },
    };
    this.plot = new uPlot(optionsOf(this.store, this.quantity, hooks, this.size), data, this.frame);
    this.dots = this.drawn.lines.map(() => element('div', { className: 'now' }));
    this.dots.forEach((dot, k) => (dot.style.background = this.drawn.lines[k].colour));
    this.plot.over.append(...this.dots);
    followFinger(this.plot, this.store.moveTo);
  }

  private range(): uPlot.Range.MinMax {
    const { band, lines } = this.drawn;
    const { reach, cuts } = shownOf(lines, this.store.current().window, largest(band ? [band.high] : [], Math.max(this.quantity.limit ?? 0, this.quantity.least ?? 0)));
    this.cuts = cuts;
    this.writeCuts();
    return rangeOf(reach);
  }

  private scale({ window: [min, max] }: State): void {
    this.plot?.setScale('x', { min, max });
  }

  showWindow(state: State): void {
    const { min, max } = this.plot?.scales.x ?? {};
    if (min !== state.window[0] || max !== state.window[1]) this.scale(state); // else its lines would be asked for, out of turn
  }

  showTime({ time }: State): void {
    const { plot } = this;
    if (plot && (!plot.cursor.event || plot.posToVal(plot.cursor.left!, 'x') !== time)) plot.setCursor({ left: plot.valToPos(time, 'x'), top: 1 }, false);
    this.drawn.lines.forEach(({ valueAt }, k) => (this.values[k].textContent = this.written(valueAt(time))));
    this.placeDots();
  }

  /** Each where its line has the value that is written; uPlot's own are at a sample beside it, and stay when lines change below them. */
  private placeDots(): void {
    const { plot, dots } = this;
    if (!plot || dots.length !== this.drawn.lines.length) return; // what is drawn waits for its turn
    const { time } = this.store.current();
    const { x, y } = plot.scales;
    this.drawn.lines.forEach(({ valueAt }, k) => {
      const value = valueAt(time);
      dots[k].hidden = !isWithin(x, time) || !isWithin(y, value);
      dots[k].style.transform = `translate(${plot.valToPos(time, 'x')}px, ${plot.valToPos(value, 'y')}px)`;
    });
  }

  private written = (value: number) => this.quantity.text?.(value, this.store.current()) ?? shown(value, this.rounding);

  /** Title, names of the lines with their values, and what is drawn beside them. */
  private write(): void {
    const { lines } = this.drawn;
    const { title, unit } = this.quantity;
    this.values = lines.map(() => element('b'));
    const names = lines.map(({ label, colour }, k) => {
      const swatch = element('i');
      swatch.style.background = colour;
      return element('span', {}, swatch, `${label} `, this.values[k]);
    });
    const ordered = [...names.filter((_, k) => !lines[k].yields), ...names.filter((_, k) => lines[k].yields)]; // what is drawn on top is named first
    this.caption.replaceChildren(element('strong', {}, title, ...(unit ? [element('small', {}, ` [${unit}] `)] : [])), ...ordered, ...this.legend(), this.cut);
    this.writeCuts();
    this.showTime(this.store.current());
  }

  private writeCuts(): void {
    this.cut.hidden = this.cuts.length === 0;
    this.cut.textContent = this.cuts.map(({ label, largest }) => `${label} goes on to ${shown(largest)}`).join(', ');
  }

  private legend(): HTMLElement[] {
    const { band, colours } = this.drawn;
    const sign = (text: string, colour: string) => {
      const made = element('em', {}, text);
      made.style.color = colour;
      return made;
    };
    const { limit, limitLabel = 'limit', marks } = this.quantity;
    return [
      ...(limit !== undefined ? [element('span', {}, sign('╌╌', colours.limit), ` ${limitLabel} `, element('b', {}, chosen(limit)))] : []),
      ...(band ? [element('span', {}, sign('▮', colours[band.place]), ` ${band.label}`)] : []),
      ...(marks ? [element('span', {}, sign('×', colours.mark), ` ${marks.label}`)] : []),
    ];
  }
}
