// SPDX-License-Identifier: Apache-2.0
// Plots over time with one cursor: it follows the time of the page, and moves it.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { momentTicks } from './clock';
import { element, place } from './element';
import { spanAt } from './motion';
import { chosen, shown, tick } from './number';
import type { Line, PlacedBand, Points, Quantity } from './quantities';
import { report } from './report';
import { choose, current, moveTo, subscribe, type State } from './state';
import { coloursOf, type Colours } from './theme';

const height = 190;
const closestKeys = 5; // [px] keys nearer to each other than this are not marked
const font = '12px system-ui, sans-serif';
const rounding = 1e-12; // of 1, or of the largest value: what is smaller is 0

function markKeys(plot: uPlot, keys: number[], colours: Colours): void {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio;
  let last = -Infinity;
  ctx.save();
  ctx.lineWidth = ratio;
  for (const t of keys) {
    const x = plot.valToPos(t, 'x', true);
    if (x < bbox.left - 1 || x > bbox.left + bbox.width + 1 || x - last < closestKeys * ratio) continue;
    last = x;
    ctx.strokeStyle = colours.grid;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.fillStyle = colours.faint;
    ctx.beginPath();
    ctx.moveTo(x - 3 * ratio, bbox.top - 4 * ratio);
    ctx.lineTo(x + 3 * ratio, bbox.top - 4 * ratio);
    ctx.lineTo(x, bbox.top + ratio);
    ctx.fill();
  }
  ctx.restore();
}

/** A dashed line that nothing is to cross. */
function drawLimit({ ctx, bbox, valToPos }: uPlot, limit: number, colours: Colours): void {
  const y = valToPos(limit, 'y', true);
  ctx.save();
  ctx.strokeStyle = colours.limit;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.setLineDash([7, 5].map((length) => length * devicePixelRatio));
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/** Between its edges, piece by piece. */
function drawBand({ ctx, bbox, valToPos }: uPlot, { place, t, low, high }: PlacedBand, colours: Colours): void {
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.globalAlpha = 0.2;
  ctx.fillStyle = colours[place];
  const point = (i: number, edge: (number | null)[]): [number, number] => [valToPos(t[i], 'x', true), valToPos(edge[i]!, 'y', true)];
  for (let from = 0; from < t.length; from++) {
    if (low[from] === null) continue;
    let to = from;
    while (to + 1 < t.length && low[to + 1] !== null) to++;
    ctx.beginPath();
    for (let i = from; i <= to; i++) ctx.lineTo(...point(i, high));
    for (let i = to; i >= from; i--) ctx.lineTo(...point(i, low));
    ctx.fill();
    from = to;
  }
  ctx.restore();
}

/** Crosses; at the upper edge where they would be above it. */
function drawMarks({ ctx, bbox, valToPos }: uPlot, { t, values }: Points, colours: Colours): void {
  const size = 4 * devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = colours.mark;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.beginPath();
  t.forEach((time, i) => {
    const x = valToPos(time, 'x', true);
    if (values[i] === null || x < bbox.left || x > bbox.left + bbox.width) return;
    const y = Math.max(valToPos(values[i]!, 'y', true), bbox.top + size);
    ctx.moveTo(x - size, y - size);
    ctx.lineTo(x + size, y + size);
    ctx.moveTo(x - size, y + size);
    ctx.lineTo(x + size, y - size);
  });
  ctx.stroke();
  ctx.restore();
}

/** The lines over all their times. */
function aligned(lines: Line[]): uPlot.AlignedData {
  if (lines.length === 0) return [[...current().extent]];
  const sameTimes = lines.every((line) => line.t === lines[0].t);
  if (sameTimes) return [lines[0].t, ...lines.map((line) => line.values)] as uPlot.AlignedData;
  const wholeGaps: uPlot.JoinNullMode[] = [2, 2]; // a gap goes on over the times of the other lines
  return uPlot.join(
    lines.map((line) => [line.t, line.values] as uPlot.AlignedData),
    lines.map(() => wholeGaps),
  );
}

/** With 0, and a range where all is 0 too. */
const rangeOf = (low: number, high: number) => uPlot.rangeNum(low < -rounding ? low : 0, high > rounding || low < -rounding ? Math.max(high, 0) : 1, 0.06, true);

interface Beside {
  ready: () => void;
  keys: number[];
  limit?: number;
  marks?: Points;
  band?: PlacedBand;
}

function optionsOf(lines: Line[], { ready, keys, limit, marks, band }: Beside, width: number, colours: Colours): uPlot.Options {
  const reach = Math.max(limit ?? 0, ...(band?.high.map((value) => value ?? 0) ?? []));
  const axis = { stroke: colours.faint, font, ticks: { stroke: colours.grid, size: 4 } };
  return {
    width,
    height,
    padding: [10, 12, 0, 0],
    legend: { show: false },
    scales: { x: { time: false }, y: { range: (_, low, high) => rangeOf(low ?? 0, Math.max(high ?? 0, reach)) } },
    axes: [
      { ...axis, grid: { show: false }, size: 28, values: (_, ticks) => momentTicks(ticks) },
      { ...axis, grid: { stroke: colours.grid, width: 1 }, size: 52, values: (_, ticks) => ticks.map(tick) },
    ],
    series: [{}, ...lines.map(({ label, colour, width, dashes }) => ({ label, stroke: colour, width, dash: dashes, spanGaps: false, points: { show: false } }))],
    cursor: { y: false, points: { size: 7 }, drag: { x: true, y: false, setScale: true }, bind: { mouseleave: () => null } },
    hooks: {
      ready: [ready],
      drawClear: [(plot) => markKeys(plot, keys, colours), (plot) => band && drawBand(plot, band, colours)],
      draw: [(plot) => limit !== undefined && drawLimit(plot, limit, colours), (plot) => marks && drawMarks(plot, marks, colours)],
      setCursor: [(plot) => plot.cursor.event && !current().playing && moveTo(plot.posToVal(plot.cursor.left!, 'x'))],
      setScale: [(plot, key) => key === 'x' && chooseWindow(plot)],
    },
  };
}

/** 1 at least. */
const largestOf = (lines: Line[]) => lines.reduce((largest, { values }) => values.reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), largest), 1);

function chooseWindow({ scales: { x } }: uPlot): void {
  const [from, to] = current().window;
  if (x.min !== undefined && x.max !== undefined && (x.min !== from || x.max !== to)) choose({ window: [x.min, x.max] });
}

/** A finger moves the time along, and the page up and down. */
function followFinger(plot: uPlot): void {
  const move = (event: PointerEvent) => {
    if (event.pointerType === 'mouse') return;
    moveTo(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  };
  plot.over.addEventListener('pointerdown', move);
  plot.over.addEventListener('pointermove', move);
  plot.over.addEventListener('click', (event) => moveTo(plot.posToVal(event.offsetX, 'x')));
}

class Plot {
  private readonly caption = element('figcaption');
  private readonly frame = element('div', { className: 'frame' });
  private readonly figure: HTMLElement;
  private plot?: uPlot;
  private lines: Line[] = [];
  private rounding = 0;
  private band?: PlacedBand;

  constructor(private readonly quantity: Quantity) {
    this.figure = element('figure', { attributes: { 'data-quantity': quantity.id } }, this.caption, this.frame);
    place('plots').append(this.figure);
    new ResizeObserver(() => this.plot?.setSize({ width: this.frame.clientWidth, height })).observe(this.frame);
  }

  rebuild(state: State): void {
    this.plot?.destroy();
    const colours = coloursOf(state);
    this.lines = this.quantity.lines(state, colours);
    this.figure.hidden = this.lines.length === 0;
    this.rounding = rounding * largestOf(this.lines);
    const { limit, marks } = this.quantity;
    const keys = this.quantity.keys(state);
    this.band = this.quantity.band?.(state);
    const ready = () => this.plot && this.showTime(current()); // before that, places in the plot are not known
    this.plot = new uPlot(optionsOf(this.lines, { ready, keys, limit, marks, band: this.band }, this.frame.clientWidth, colours), aligned(this.lines), this.frame);
    followFinger(this.plot);
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
    this.caption.replaceChildren(element('strong', {}, this.quantity.title), ...unit, ...values, ...this.legend(coloursOf(current())));
  }

  /** What is drawn beside the lines. */
  private legend(colours: Colours): HTMLElement[] {
    const sign = (text: string, colour: string) => {
      const made = element('em', {}, text);
      made.style.color = colour;
      return made;
    };
    const { limit, limitLabel = 'limit' } = this.quantity;
    return [
      ...(limit !== undefined ? [element('span', {}, sign('╌╌', colours.limit), ` ${limitLabel} `, element('b', {}, chosen(limit)))] : []),
      ...(this.band ? [element('span', {}, sign('▮', colours[this.band.place]), ` ${this.band.label}`)] : []),
      ...(this.quantity.marks ? [element('span', {}, sign('×', colours.mark), ` ${report.marks!.label}`)] : []),
    ];
  }
}

/** Whether the components of the first method are drawn too. */
export function componentsChoice(): HTMLElement {
  const box = element('input', { type: 'checkbox', onchange: () => choose({ components: box.checked }) });
  subscribe(['components'], ({ components }) => (box.checked = components));
  return element('div', { className: 'controls' }, element('label', { className: 'choice' }, box, element('span', {}, 'Components x, y, z of the first method')));
}

/** They are made anew when one of the fields changes. */
export function showPlots(quantities: Quantity[], fields: (keyof State)[], ...controls: HTMLElement[]): void {
  place('plots').append(...controls);
  const plots = quantities.map((quantity) => new Plot(quantity));
  const every = (update: (plot: Plot, state: State) => void) => (state: State) => plots.forEach((plot) => update(plot, state));
  subscribe([...fields, 'theme'], every((plot, state) => plot.rebuild(state)));
  subscribe(['window'], every((plot, state) => plot.showWindow(state)));
  subscribe(['time'], every((plot, state) => plot.showTime(state)));
}
