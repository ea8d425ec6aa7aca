// SPDX-License-Identifier: Apache-2.0
// What is drawn into a plot beside its lines.
import type uPlot from 'uplot';
import type { Numbers } from '../data/numbers';
import { widths, type Colours } from '../look/theme';
import type { Flags, PlacedBand, Points } from '../quantities/quantity';

export const closestKeys = 12; // [px] keys nearer to each other than this are not marked
export const cell = 7; // [px] of several marks in a square of this size one is drawn
const manyMarks = 150; // are drawn as dots

/** Says whether some are not marked. */
export function markKeys(plot: uPlot, keys: Numbers, colours: Colours): boolean {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio;
  let last = -Infinity;
  let areThinned = false;
  ctx.save();
  ctx.lineWidth = ratio;
  for (const t of keys) {
    const x = plot.valToPos(t, 'x', true);
    if (x < bbox.left - 1 || x > bbox.left + bbox.width + 1) continue;
    if (x - last < closestKeys * ratio) {
      areThinned = true;
      continue;
    }
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
  return areThinned;
}

/** Stretches of time in full height, and moments as lines. */
export function drawFlags({ ctx, bbox, valToPos }: uPlot, { spans, times }: Flags, colours: Colours): void {
  const placeOf = (time: number) => Math.min(Math.max(valToPos(time, 'x', true), bbox.left), bbox.left + bbox.width);
  ctx.save();
  ctx.fillStyle = ctx.strokeStyle = colours.limit;
  ctx.globalAlpha = 0.16;
  for (const [from, to] of spans) ctx.fillRect(placeOf(from), bbox.top, placeOf(to) - placeOf(from), bbox.height);
  ctx.globalAlpha = 1;
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.setLineDash([3, 3].map((length) => length * devicePixelRatio));
  ctx.beginPath();
  for (const time of times) {
    const x = valToPos(time, 'x', true);
    if (x < bbox.left || x > bbox.left + bbox.width) continue;
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
  }
  ctx.stroke();
  ctx.restore();
}

/** A dashed line that nothing is to cross. */
export function drawLimit({ ctx, bbox, valToPos }: uPlot, limit: number, colours: Colours): void {
  const y = valToPos(limit, 'y', true);
  ctx.save();
  ctx.strokeStyle = colours.limit;
  ctx.lineWidth = widths.limit * devicePixelRatio;
  ctx.setLineDash([7, 5].map((length) => length * devicePixelRatio));
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/** Between its edges, piece by piece. */
export function drawBand({ ctx, bbox, valToPos }: uPlot, { place, t, low, high }: PlacedBand, colours: Colours): void {
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.globalAlpha = 0.2;
  ctx.fillStyle = colours[place];
  const point = (i: number, edge: Numbers): [number, number] => [valToPos(t[i], 'x', true), valToPos(edge[i], 'y', true)];
  for (let from = 0; from < t.length; from++) {
    if (Number.isNaN(low[from])) continue;
    let to = from;
    while (to + 1 < t.length && !Number.isNaN(low[to + 1])) to++;
    ctx.beginPath();
    for (let i = from; i <= to; i++) ctx.lineTo(...point(i, high));
    for (let i = to; i >= from; i--) ctx.lineTo(...point(i, low));
    ctx.fill();
    from = to;
  }
  ctx.restore();
}

/** One of the points in each small square of the picture; at the upper edge where they would be above it. */
function placesOf({ bbox, valToPos }: uPlot, { t, values }: Points): { places: [x: number, y: number][]; areThinned: boolean } {
  const size = cell * devicePixelRatio;
  const places = new Map<string, [number, number]>();
  let areThinned = false;
  t.forEach((time, i) => {
    const x = valToPos(time, 'x', true);
    if (Number.isNaN(values[i]) || x < bbox.left || x > bbox.left + bbox.width) return;
    const y = Math.max(valToPos(values[i], 'y', true), bbox.top + size / 2);
    const square = `${Math.floor(x / size)} ${Math.floor(y / size)}`;
    if (places.has(square)) areThinned = true;
    else places.set(square, [x, y]);
  });
  return { places: [...places.values()], areThinned };
}

/** Crosses; of many, dots. Says whether some are not drawn. */
export function drawMarks(plot: uPlot, points: Points, colours: Colours): boolean {
  const { ctx } = plot;
  const { places, areThinned } = placesOf(plot, points);
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  if (places.length > manyMarks) {
    ctx.fillStyle = colours.mark;
    ctx.globalAlpha = 0.55;
    for (const [x, y] of places) ctx.rect(x - ratio, y - ratio, 2 * ratio, 2 * ratio);
    ctx.fill();
  } else {
    const size = 3.5 * ratio;
    ctx.strokeStyle = colours.mark;
    ctx.lineWidth = 1.5 * ratio;
    for (const [x, y] of places) {
      ctx.moveTo(x - size, y - size);
      ctx.lineTo(x + size, y + size);
      ctx.moveTo(x - size, y + size);
      ctx.lineTo(x + size, y - size);
    }
    ctx.stroke();
  }
  ctx.restore();
  return areThinned;
}
