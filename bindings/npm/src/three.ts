// SPDX-License-Identifier: Apache-2.0
// Tracks of three.js. Nothing of three.js is imported: a track is what has these members.
import type { Curve } from './curve.js';
import { badArgument, optionsOf, shown } from './errors.js';
import { numbersOf } from './numbers.js';
import type { Settings } from './method.js';
import type { Orispline } from './orispline.js';
import type { Numbers, Playable } from './playable.js';

/** What an AnimationMixer asks of an interpolant. */
export interface Interpolant {
  parameterPositions: ArrayLike<number>;
  sampleValues: ArrayLike<number>;
  valueSize: number;
  resultBuffer: Numbers;
  settings: unknown;
  evaluate(time: number): Numbers;
}

/** A QuaternionKeyframeTrack or VectorKeyframeTrack. */
export interface Track {
  name: string;
  times: ArrayLike<number>;
  values: ArrayLike<number>;
  ValueTypeName: string;
  createInterpolant?: unknown;
  getInterpolation?(): unknown;
  clone?(): unknown;
}

const kinds = ['quaternion', 'vector'];

const curveOf = (ori: Orispline, track: Track, method: string, settings: Settings): Curve => {
  if (typeof ori?.curve !== 'function') throw badArgument('ori', `found ${shown(ori)}, wanted what load() gives`);
  if (typeof track !== 'object' || !track) throw badArgument('track', `found ${shown(track)}, wanted a track of three.js`);
  const { name, values, ValueTypeName } = track, times = numbersOf('times', track.times);
  if (!kinds.includes(ValueTypeName)) throw badArgument('track', `found ${name} of the type ${ValueTypeName}, wanted a quaternion or a vector`);
  if (ValueTypeName === 'quaternion') return ori.curve(method, { times, orientations: values, order: 'xyzw' }, settings);
  const still = Float32Array.from({ length: 4 * times.length }, (_, k) => (k % 4 === 3 ? 1 : 0));
  return ori.curve(method, { times, orientations: still, positions: values, order: 'xyzw' }, settings);
};

class ExactInterpolant implements Interpolant {
  readonly parameterPositions: ArrayLike<number>;
  readonly sampleValues: ArrayLike<number>;
  readonly valueSize: number;
  resultBuffer: Numbers;
  settings: unknown;
  private readonly curve: Curve;
  private readonly isVector: boolean;

  constructor(curve: Curve, track: Track, result: Numbers | null | undefined) {
    this.curve = curve;
    this.isVector = track.ValueTypeName === 'vector';
    this.parameterPositions = track.times;
    this.sampleValues = track.values;
    this.valueSize = this.isVector ? 3 : 4;
    this.resultBuffer = result ?? new Float64Array(this.valueSize);
  }

  evaluate(time: number): Numbers {
    return this.isVector ? this.curve.positionAt(time, this.resultBuffer) : this.curve.at(time, this.resultBuffer);
  }
}

let isTold = false;

const tellOnce = ({ name }: Track): void => {
  if (!isTold) console.warn(`orispline/three: found the track ${name}, which animate() moves, written or optimised by three.js, which takes slerp for its curve; wanted a track of bake()`);
  isTold = true;
};

/**
 * Gives a track and its clones an interpolant. Which interpolation a track has, three.js asks where it writes or optimises it alone: `toJSON`, GLTFExporter
 * and `optimize` do not know this one.
 */
const withInterpolant = <Kind extends Track>(track: Kind, createInterpolant: unknown): Kind => {
  const { getInterpolation, clone } = track;
  return Object.assign(track, {
    createInterpolant,
    getInterpolation(this: Track): unknown {
      if (this.createInterpolant === createInterpolant) tellOnce(this);
      return getInterpolation?.call(this);
    },
    clone(this: Track): unknown {
      const copy = clone?.call(this) as Track;
      return copy.createInterpolant === createInterpolant ? withInterpolant(copy, createInterpolant) : copy;
    },
  });
};

/**
 * Lets a quaternion or vector track move along the curve of a method through its keys, exactly, also where it is cloned. What is wrong with the keys is
 * told at once.
 *
 * `toJSON` and GLTFExporter do not know the curve: they write the keys, between which others then go by slerp. A
 * warning says so, once. To write it, bake it.
 */
export const animate = <Kind extends Track>(ori: Orispline, track: Kind, method = 'auto', settings: Settings = {}): Kind => {
  curveOf(ori, track, method, settings).dispose();
  return withInterpolant(track, function (this: Track, result?: Numbers | null): Interpolant {
    return new ExactInterpolant(curveOf(ori, this, method, settings), this, result);
  });
};

type Quaternion = [x: number, y: number, z: number, w: number];

/** The way from one orientation to another as three.js goes from key to key, and how far from it others are. */
class Slerp {
  private readonly sign: number;
  private readonly half: number;
  private readonly sine: number;
  private readonly a: Quaternion;
  private readonly b: Quaternion;

  constructor(a: Quaternion, b: Quaternion) {
    this.a = a;
    this.b = b;
    this.sign = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -1 : 1;
    this.half = 2 * Math.asin(Math.min(Math.hypot(...a.map((x, i) => x - this.sign * b[i])) / 2, 1));
    this.sine = Math.sin(this.half);
  }

  /** The angle from where it is after a share of the way [rad]. */
  angleFrom(share: number, q: Quaternion): number {
    const { a, b, half, sine, sign } = this, isShort = half < 1e-6;
    const from = isShort ? 1 - share : Math.sin((1 - share) * half) / sine, to = sign * (isShort ? share : Math.sin(share * half) / sine);
    let near = 0, far = 0; // squares of the distances from q and -q
    for (let i = 0; i < 4; ++i) {
      const component = from * a[i] + to * b[i];
      near += (component - q[i]) ** 2;
      far += (component + q[i]) ** 2;
    }
    return 4 * Math.asin(Math.min(Math.sqrt(Math.min(near, far)) / 2, 1));
  }
}

const leastTolerance = 1e-6, mostSamples = 2 ** 16;
/** So many spans in a row that miss the tolerance end the search for a longer one. */
const patience = 8;

/** How far apart the numbers are that a Float32Array holds, near one of them. */
const floatStep = (number: number): number => 2 ** (Math.floor(Math.log2(Math.abs(number))) - 23);

/** Samples at times that a track can hold, so close that what lies between two of them is nowhere farther from a slerp than an eighth of the tolerance. */
const samplesOf = (curve: Playable, tolerance: number): { times: number[]; values: Quaternion[] } => {
  for (let count = 64; ; count *= 2) {
    const times = Array.from({ length: 2 * count + 1 }, (_, k) => Math.fround(curve.start + ((curve.end - curve.start) * k) / (2 * count)));
    if (times.some((time, k) => time <= times[k - 1]))
      throw badArgument('curve', `found times from ${curve.start} to ${curve.end} s, which a track holds in steps of ${floatStep(curve.end)} s, wanted some that count from near 0`);
    const values = times.map((time) => [...curve.at(time)] as Quaternion);
    let most = 0;
    for (let k = 0; k < 2 * count; k += 2) most = Math.max(most, new Slerp(values[k], values[k + 2]).angleFrom((times[k + 1] - times[k]) / (times[k + 2] - times[k]), values[k + 1]));
    if (8 * most <= tolerance) return { times, values };
    if (count > mostSamples) throw badArgument('tolerance', `found ${tolerance} rad, wanted a larger one: ${mostSamples} keys do not keep to it`);
  }
};

/**
 * The times and values of a linear track, which goes by slerp, within `tolerance` [rad] of a curve, with the fewest keys:
 * `new QuaternionKeyframeTrack(name, ...bake(curve, { tolerance: 1e-3 }))`. The curve gives x, y, z, w.
 */
export const bake = (curve: Playable & { order?: string }, options: { tolerance: number }): [times: Float32Array, values: Float32Array] => {
  const { tolerance } = optionsOf('options', options);
  if (typeof curve?.at !== 'function' || !Number.isFinite(curve.start)) throw badArgument('curve', `found ${shown(curve)}, wanted a curve or a player`);
  if (typeof tolerance !== 'number' || !(tolerance >= leastTolerance)) throw badArgument('tolerance', `found ${shown(tolerance)} rad, wanted ${leastTolerance} rad or more, which is what a track holds`);
  if (curve.order === 'wxyz') throw badArgument('curve', "found one in the order 'wxyz', wanted 'xyzw', as three.js has it");
  if (curve.start === curve.end) return [Float32Array.of(curve.start), Float32Array.from([...curve.at(curve.start)])];
  const { times, values } = samplesOf(curve, tolerance), last = times.length - 1, allowed = 0.875 * tolerance;
  const keeps = (from: number, to: number): boolean => {
    const way = new Slerp(values[from], values[to]), length = times[to] - times[from];
    for (let k = from + 1; k < to; ++k) if (way.angleFrom((times[k] - times[from]) / length, values[k]) > allowed) return false;
    return true;
  };
  // The fewest spans from the first sample to each, and the one before it on that way.
  const spans = new Array<number>(last + 1).fill(Infinity), before = new Array<number>(last + 1).fill(0);
  spans[0] = 0;
  for (let from = 0; from < last; ++from)
    for (let to = from + 1, misses = 0; to <= last && misses < patience; ++to)
      if (!keeps(from, to)) ++misses;
      else if (((misses = 0), spans[from] + 1 < spans[to])) (spans[to] = spans[from] + 1), (before[to] = from);
  const kept: number[] = [];
  for (let k = last; k > 0; k = before[k]) kept.unshift(k);
  kept.unshift(0);
  return [Float32Array.from(kept, (k) => times[k]), Float32Array.from(kept.flatMap((k) => values[k]))];
};
