// SPDX-License-Identifier: Apache-2.0
// Orientations and positions between the samples.
import type { Numbers } from '../data/numbers';
import { isGap, type Clock, type Path } from '../data/report';
import { exponential, exponentialsOf, four, inverse, logarithm, multiply, product, quaternionIn, type Place, type Quaternion, type Vector } from './quaternion';

export const quaternionAt = ({ q }: Path, i: number): Quaternion => [q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]];

/** Index of the last time that is not after t, at most the last but one. */
export function spanAt(times: Numbers, t: number): number {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return low;
}

/** How far t is from time i to the next one, 0 to 1. */
export function fraction(times: Numbers, i: number, t: number): number {
  const step = times[i + 1] - times[i];
  return step > 0 ? Math.min(Math.max((t - times[i]) / step, 0), 1) : 0;
}

/** Writes the orientation at a part of the way, 0 to 1. */
export type Segment = (into: Place, u: number) => void;

/** From one orientation to the next along the shorter arc. */
function arc(from: Quaternion, to: Quaternion): Segment {
  const [start, turned] = [four(from), exponentialsOf(logarithm(product(inverse(from), to)))];
  return (into, u) => {
    turned(into, u);
    multiply(into, start, into);
  };
}

const turn = four();

/**
 * The cubic of Kim, Kim and Shin (1995), which has the rates at both ends; the turns are a third of the step times these. The
 * library chooses the samples so that this formula is near to the curve.
 */
function cubic(from: Quaternion, first: Vector, to: Quaternion, last: Vector): Segment {
  const between = logarithm(product(inverse(product(from, exponential(first))), product(to, inverse(exponential(last)))));
  const start = four(from), atFirst = exponentialsOf(first), inside = exponentialsOf(between), atLast = exponentialsOf(last);
  return (into, u) => {
    const rest = 1 - u;
    atFirst(into, 1 - rest * rest * rest);
    multiply(into, start, into);
    inside(turn, u * u * (3 - 2 * u));
    multiply(into, into, turn);
    atLast(turn, u * u * u);
    multiply(into, into, turn);
  };
}

const mostTurn = 20 * Math.PI; // in a third of a step: rates that turn more are not those of the samples

/** With rates, unless these are noise. */
type Rated = Path & { w?: Numbers; straight?: boolean };

/** Between sample i and the next one: nothing where there is a gap. */
export function segmentOf(path: Rated, i: number): Segment | null {
  const { t, w, straight } = path;
  if (isGap(path, i) || isGap(path, i + 1)) return null;
  const [from, to] = [quaternionAt(path, i), quaternionAt(path, i + 1)];
  if (!w || straight || w.length < 3 * t.length) return arc(from, to);
  const third = (t[i + 1] - t[i]) / 3;
  const turnAt = (k: number): Vector => [third * w[3 * k], third * w[3 * k + 1], third * w[3 * k + 2]];
  const [first, last] = [turnAt(i), turnAt(i + 1)];
  const isSampled = Math.max(Math.hypot(...first), Math.hypot(...last)) <= mostTurn; // NaN is not
  return isSampled ? cubic(from, first, to, last) : arc(from, to);
}

/** Whether there is an orientation at the time, and not a gap. */
export function isShownAt(path: Path, t: number): boolean {
  const i = spanAt(path.t, t);
  if (t <= path.t[i]) return !isGap(path, i);
  return !isGap(path, i + 1) && (!isGap(path, i) || t >= path.t[i + 1]);
}

export function orientationAt(path: Rated, t: number): Quaternion {
  const i = spanAt(path.t, t);
  const u = path.t.length > 1 ? fraction(path.t, i, t) : 0;
  if (!(u > 0 && u < 1)) return quaternionAt(path, i + u);
  const place = four();
  segmentOf(path, i)!(place, u);
  return quaternionIn(place);
}

export function vectorAt(times: Numbers, values: Numbers, t: number): Vector {
  const i = spanAt(times, t);
  const u = times.length > 1 ? fraction(times, i, t) : 0;
  const next = Math.min(i + 1, times.length - 1);
  return [0, 1, 2].map((k) => (1 - u) * values[3 * i + k] + u * values[3 * next + k]) as Vector;
}

/** The own time of a motion at a time of the page. */
export function ownTime(clock: Clock | null, time: number): number {
  if (!clock || clock.t.length < 2) return time;
  const i = spanAt(clock.t, time);
  const u = fraction(clock.t, i, time);
  return (1 - u) * clock.own[i] + u * clock.own[i + 1];
}
