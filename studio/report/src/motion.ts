// SPDX-License-Identifier: Apache-2.0
// Orientations between the samples, and quantities of the plots.
import { isGap, type Path } from './report';

export type Quaternion = [w: number, x: number, y: number, z: number];
export type Vector = [x: number, y: number, z: number];
export type Axis = 'x' | 'y' | 'z';

export const quaternionAt = ({ q }: Path, i: number) => q.slice(4 * i, 4 * i + 4) as Quaternion;

/** Index of the last time that is not after t, at most the last but one. */
export function spanAt(times: number[], t: number): number {
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
export function fraction(times: number[], i: number, t: number): number {
  const step = times[i + 1] - times[i];
  return step > 0 ? Math.min(Math.max((t - times[i]) / step, 0), 1) : 0;
}

/** Samples are dense: the chord, scaled to unit length, is the arc to the eye. */
export function orientationAt(path: Path, t: number): Quaternion {
  if (path.t.length === 1) return quaternionAt(path, 0);
  const i = spanAt(path.t, t);
  const u = fraction(path.t, i, t);
  const [a, b] = [quaternionAt(path, i), quaternionAt(path, i + 1)];
  const side = a.reduce((sum, value, k) => sum + value * b[k], 0) < 0 ? -1 : 1;
  const chord = a.map((value, k) => (1 - u) * value + u * side * b[k]) as Quaternion;
  const norm = Math.hypot(...chord);
  return chord.map((value) => value / norm) as Quaternion;
}

export function vectorAt(times: number[], values: number[], t: number): Vector {
  const i = spanAt(times, t);
  const u = times.length > 1 ? fraction(times, i, t) : 0;
  const next = Math.min(i + 1, times.length - 1);
  return [0, 1, 2].map((k) => (1 - u) * values[3 * i + k] + u * values[3 * next + k]) as Vector;
}

/** Direction of a body axis in the world. */
export function bodyAxis([w, x, y, z]: Quaternion, axis: Axis): Vector {
  if (axis === 'x') return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  if (axis === 'y') return [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}

/** Angle of the rotation from one orientation to the other [deg], 0 to 180. */
function angleBetween([w, x, y, z]: Quaternion, [a, b, c, d]: Quaternion): number {
  const scalar = w * a + x * b + y * c + z * d;
  const vector = Math.hypot(w * b - x * a - y * d + z * c, w * c + x * d - y * a - z * b, w * d - x * c + y * b - z * a);
  return (2 * Math.atan2(vector, Math.abs(scalar)) * 180) / Math.PI;
}

/** Whether there is an orientation at the time, and not a gap. */
export function isShownAt(path: Path, t: number): boolean {
  const i = spanAt(path.t, t);
  return !isGap(path, i) && !(t > path.t[i] && isGap(path, i + 1));
}

export function anglesFromStart(path: Path): (number | null)[] {
  const start = quaternionAt(path, 0);
  return path.t.map((_, i) => (isGap(path, i) ? null : angleBetween(start, quaternionAt(path, i))));
}

/** At the times of the first. */
export const anglesApart = (path: Path, other: Path) =>
  path.t.map((t, i) => (isGap(path, i) || !isShownAt(other, t) ? null : angleBetween(quaternionAt(path, i), orientationAt(other, t))));

export const component = (values: (number | null)[], k: number) => Array.from({ length: values.length / 3 }, (_, i) => values[3 * i + k]);

export const magnitudes = (values: (number | null)[]) =>
  Array.from({ length: values.length / 3 }, (_, i) => (values[3 * i] === null ? null : Math.hypot(values[3 * i]!, values[3 * i + 1]!, values[3 * i + 2]!)));
