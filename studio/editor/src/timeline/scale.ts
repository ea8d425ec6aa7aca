// SPDX-License-Identifier: Apache-2.0
// Where times and values are on the timeline [px].
import { roundStep } from 'orispline-viewer/look/number';

export const inset = 20; // at both ends, so that the first and the last key are whole

export interface Scale {
  from: number; // [s]
  to: number;
  width: number; // [px]
}

/** Where there is one moment only, a second is as wide as all. */
export const perPixel = ({ from, to, width }: Scale): number => (to > from ? to - from : 1) / Math.max(width - 2 * inset, 1);
export const placeOf = (scale: Scale, time: number): number => inset + (time - scale.from) / perPixel(scale);
export const timeAt = (scale: Scale, x: number): number => scale.from + (x - inset) * perPixel(scale);

/** A time that can be seen on the scale, with few digits. */
export function roundTime(scale: Scale, time: number): number {
  const step = roundStep(perPixel(scale));
  return Number((Math.round(time / step) * step).toPrecision(15));
}

/** Of the places from left to right those that are so far apart; the kept one is among them. */
export function apart(places: number[], least: number, kept: number): number[] {
  const shown: number[] = [];
  places.forEach((x, i) => {
    const isNear = shown.length > 0 && x - places[shown[shown.length - 1]] < least;
    if (isNear && i !== kept) return;
    if (isNear && shown.length > 0) shown.pop();
    shown.push(i);
  });
  return shown;
}

/** The nearest of the places, within reach; −1: none. */
export function nearest(places: number[], x: number, reach: number): number {
  let best = -1;
  places.forEach((place, i) => {
    if (Math.abs(place - x) <= reach && (best < 0 || Math.abs(place - x) < Math.abs(places[best] - x))) best = i;
  });
  return best;
}

const betweenMarks = 72; // [px] at least

/** Round times to be marked. */
export function marks(scale: Scale): number[] {
  const least = perPixel(scale) * betweenMarks;
  let step = roundStep(least);
  while (step < least) step = roundStep(step * 2.5);
  const first = Math.ceil(timeAt(scale, 0) / step);
  const last = Math.floor(timeAt(scale, scale.width) / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Stretch of time around a place of the old one that stays where it is; never more than there is. */
export function zoomed([from, to]: readonly [number, number], [start, end]: readonly [number, number], around: number, factor: number): [number, number] {
  const span = Math.min(Math.max((to - from) * factor, (end - start) * 1e-4), end - start);
  const share = to > from ? Math.min(Math.max((around - from) / (to - from), 0), 1) : 0.5;
  return slid([around - share * span, around + (1 - share) * span], [start, end], 0);
}

export function slid([from, to]: readonly [number, number], [start, end]: readonly [number, number], by: number): [number, number] {
  const span = Math.min(to - from, end - start);
  const first = Math.min(Math.max(from + by, start), end - span);
  return [first, first + span];
}

/** What bars reach from and to: all values with 0, and room above the default. */
export function reachOf(values: readonly number[], usual: number, { min, max }: { min: number; max: number }): { low: number; high: number } {
  const [least, most] = values.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Math.min(0, usual), Math.max(0, usual)]);
  const high = most > 0 ? Math.max(most * 1.25, 2 * usual, least < 0 ? -least : 0, Math.min(1, max)) : Math.min(1, max);
  const low = least < 0 ? least * 1.25 : usual === 0 && min < 0 ? -high : Math.max(0, min);
  return { low: Math.max(low, min), high: Math.min(high, max) };
}

/** Of an arrow key. */
export const stepOf = ({ low, high }: { low: number; high: number }): number => roundStep((high - low) / 20);
