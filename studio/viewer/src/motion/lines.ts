// SPDX-License-Identifier: Apache-2.0
// Angles over time and ways over the sphere, drawn within a stated angle.
import type { Numbers } from '../data/numbers';
import { isGap, type Path } from '../data/report';
import { isShownAt, orientationAt, quaternionAt, segmentOf, spanAt } from './orientation';
import { polyline, type Piece, type Polyline } from './polyline';
import { angleBetween, angleOf, axisOf, four, type Axis, type Place, type Quaternion } from './quaternion';

/** [deg] Of a chord from what it stands for. */
export const chordTolerance = 0.005;

const radian = 180 / Math.PI; // [deg]

/** The orientation between two samples at a time: it lies where that of another time is written next. */
function turnsIn(path: Path, i: number, into: Place): ((t: number) => Place) | null {
  const segment = segmentOf(path, i);
  if (!segment) return null;
  const from = path.t[i], step = path.t[i + 1] - from;
  return (t) => {
    segment(into, (t - from) / step);
    return into;
  };
}

/** Values of the orientations of a path. */
function piecesOf(path: Path, valuesOf: (q: Place) => number[]): (i: number) => Piece | null {
  const place = four();
  return (i) => {
    const turns = turnsIn(path, i, place);
    return turns && ((t) => valuesOf(turns(t)));
  };
}

/** Its first orientation. */
function startOf(path: Path): Quaternion | null {
  const first = path.t.findIndex((_, i) => !isGap(path, i));
  return first < 0 ? null : quaternionAt(path, first);
}

/** [deg] */
export function anglesFromStart(path: Path): Polyline {
  const start = startOf(path);
  if (!start) return { t: new Float64Array(), values: new Float64Array() };
  const from = four(start);
  return polyline(path.t, piecesOf(path, (q) => [angleOf(from, q)]), chordTolerance);
}

/** The same at any time; NaN in a gap. */
export function angleFromStartAt(path: Path): (time: number) => number {
  const start = startOf(path);
  return (time) => (start && isShownAt(path, time) ? angleBetween(start, orientationAt(path, time)) : NaN);
}

/** The way of a body axis over the unit sphere. */
export const wayOverSphere = (path: Path, axis: Axis): Polyline => polyline(path.t, piecesOf(path, (q) => axisOf(q, axis)), chordTolerance / radian);

/** All times of both, each once. */
function unionOf(some: Numbers, others: Numbers): Float64Array {
  const all = new Float64Array(some.length + others.length);
  all.set(some);
  all.set(others, some.length);
  return all.sort().filter((t, i) => i === 0 || t !== all[i - 1]);
}

/** The angle between both [deg], where both are. */
export function anglesApart(path: Path, other: Path): Polyline {
  const times = unionOf(path.t, other.t);
  const [here, there] = [four(), four()];
  const turnsAt = (one: Path, t: number, into: Place) => (t < one.t[0] || t > one.t[one.t.length - 1] ? null : turnsIn(one, spanAt(one.t, t), into));
  const pieceOf = (i: number): Piece | null => {
    const middle = (times[i] + times[i + 1]) / 2;
    const [first, second] = [turnsAt(path, middle, here), turnsAt(other, middle, there)];
    return first && second && ((t) => [angleOf(first(t), second(t))]);
  };
  return polyline(times, pieceOf, chordTolerance);
}

/** The same at any time; NaN where there is only one of both. */
export function angleApartAt(path: Path, other: Path): (time: number) => number {
  const isAt = (one: Path, time: number) => time >= one.t[0] && time <= one.t[one.t.length - 1] && isShownAt(one, time);
  return (time) => (isAt(path, time) && isAt(other, time) ? angleBetween(orientationAt(path, time), orientationAt(other, time)) : NaN);
}
