// SPDX-License-Identifier: Apache-2.0
/// <reference lib="esnext.disposable" preserve="true" />
import type { Address, Engine } from './engine.js';
import { OrisplineError, badArgument, optionsOf, shown } from './errors.js';
import { type KeyData, type Order, checkedKeys, chosen, orderOf, withKeys } from './keys.js';
import { type Settings, methodText } from './method.js';
import { checkRoom, numbersOf, roomFor } from './numbers.js';
import type { Numbers, Playable } from './playable.js';

/** How the body moves at one time. */
export interface Motion {
  /** In the order of the keys. */
  orientation: number[];
  /** [rad/s], body. */
  angularVelocity: number[];
  /** [rad/s²], body. */
  angularAcceleration: number[];
  /** [rad/s³], body. */
  angularJerk: number[];
  /** [m], world, where the keys have positions, as is all that follows. */
  position?: number[];
  /** [m/s]. */
  velocity?: number[];
  /** [m/s²]. */
  acceleration?: number[];
  /** [m/s³]. */
  jerk?: number[];
}

/** Which samples: at given times, or `count` even ones. Without `count` those up to the end. */
export interface SampleOptions {
  times?: ArrayLike<number>;
  /** [s]; the start of the curve. */
  start?: number;
  /** [s]. */
  step?: number;
  count?: number;
  /** Up to which order rates are wanted: 0 none, 1 angular velocities, 2 and accelerations, 3 and jerks. */
  rates?: 0 | 1 | 2 | 3;
}

/** Samples row after row. */
export interface Samples {
  /** [s]. */
  times: Float64Array;
  /** In the order of the keys. */
  orientations: Float64Array;
  /** [rad/s], body. */
  angularVelocities?: Float64Array;
  /** [rad/s²], body. */
  angularAccelerations?: Float64Array;
  /** [rad/s³], body. */
  angularJerks?: Float64Array;
  /** [m], world, where the keys have positions. */
  positions?: Float64Array;
}

/** The rates of a sample, by their order. */
const rateNames = ['angularVelocities', 'angularAccelerations', 'angularJerks'] as const;

/** Those that are asked for. */
export const ratesOf = (options: SampleOptions): (typeof rateNames)[number][] => {
  const { rates = 0 } = optionsOf('options', options);
  if (![0, 1, 2, 3].includes(rates)) throw badArgument('rates', `found ${shown(rates)}, wanted 0, 1, 2 or 3`);
  return rateNames.slice(0, rates);
};

const sides = { right: 0, left: 1 };

const checkedCount = (count: number): number => {
  if (!Number.isInteger(count) || count < 0) throw badArgument('count', `found ${shown(count)}, wanted a whole number from 0 on`);
  return count;
};

/** The times that are asked for. */
export const timesOf = (curve: Playable, options: SampleOptions): Float64Array => {
  const { times, start = curve.start, step, count } = optionsOf('options', options);
  if (times) return numbersOf('times', times);
  if (!Number.isFinite(step) || !(step! > 0)) throw badArgument('step', `found ${shown(step)}, wanted times, or a step of more than 0 s`);
  if (!Number.isFinite(start)) throw badArgument('start', `found ${shown(start)}, wanted a time [s]`);
  // Half a billionth of a step: what rounding takes from an end that is a multiple of it.
  const all = checkedCount(count ?? Math.max(Math.floor((curve.end - start) / step! + 5e-10) + 1, 0));
  checkRoom(4 * all); // of the orientations
  const even = roomFor(all);
  for (let k = 0; k < all; ++k) even[k] = k * step! + start;
  return even;
};

/** Four numbers with a fraction: once V8 has seen a list grow here, it writes into every kind of target several times slower. */
const fourNumbers = (): Numbers => [NaN, NaN, NaN, NaN];

/** That numbers cannot be written there, such as into null, or what is frozen. */
const noTarget = (target: unknown): OrisplineError => badArgument('target', `found ${shown(target)}, wanted an array that can be written`);

/** A curve through keys. It is freed where it is disposed of, or some time after it was forgotten. */
export class Curve implements Playable {
  readonly start: number;
  readonly end: number;
  readonly order: Order;
  readonly hasPositions: boolean;
  protected readonly engine: Engine;
  protected readonly keyCount: number;
  private address: Address;
  protected readonly orderNumber: number;
  private readonly forgotten: FinalizationRegistry<Address>;

  /** Of an `Orispline`, by its `curve`. */
  constructor(engine: Engine, forgotten: FinalizationRegistry<Address>, method: string, data: KeyData, settings: Settings) {
    this.engine = engine;
    this.order = checkedKeys(data).order;
    this.orderNumber = orderOf(data.order);
    const text = methodText(method, settings);
    this.address = withKeys(engine, data, (keys) => engine.withText(text, (at) => engine.made('orispline_curve_make', keys, at)));
    this.keyCount = data.times.length;
    engine.check('orispline_curve_domain', this.address, engine.numbersAt, engine.numbersAt + 8);
    [this.start, this.end] = this.told(0, 2);
    this.hasPositions = engine.call('orispline_curve_has_positions', this.address) === 1;
    this.forgotten = forgotten;
    forgotten.register(this, this.address, this);
  }

  /** Writes the orientation at a time [s] into `target` and returns it. It allocates nothing where there is a target. */
  at<Target extends Numbers = number[]>(time: number, target = fourNumbers() as Target): Target {
    this.engine.orientation(this.handle, time, this.orderNumber);
    const { numbers, numbersAt } = this.engine, from = numbersAt / 8;
    try {
      target[0] = numbers[from];
      target[1] = numbers[from + 1];
      target[2] = numbers[from + 2];
      target[3] = numbers[from + 3];
    } catch {
      throw noTarget(target);
    }
    return target;
  }

  /** Writes the position [m] in the same way, where the keys have positions. */
  positionAt<Target extends Numbers = number[]>(time: number, target = [NaN, NaN, NaN] as Numbers as Target): Target {
    const { engine } = this, from = engine.numbersAt / 8 + 13;
    engine.check('orispline_curve_motion', this.handle, time, 0, this.orderNumber, engine.numbersAt);
    if (!this.hasPositions) throw badArgument('positions', 'found keys without any, wanted three numbers for each');
    try {
      for (let i = 0; i < 3; ++i) target[i] = engine.numbers[from + i];
    } catch {
      throw noTarget(target);
    }
    return target;
  }

  /** The motion at a time [s]; at a key where rates jump that of the segment behind it, or of the one before it. */
  motion(time: number, side: 'right' | 'left' = 'right'): Motion {
    this.engine.check('orispline_curve_motion', this.handle, time, chosen('side', side, sides), this.orderNumber, this.engine.numbersAt);
    const motion: Motion = {
      orientation: this.told(0, 4), angularVelocity: this.told(4, 3), angularAcceleration: this.told(7, 3), angularJerk: this.told(10, 3),
    };
    if (!this.hasPositions) return motion;
    return { ...motion, position: this.told(13, 3), velocity: this.told(16, 3), acceleration: this.told(19, 3), jerk: this.told(22, 3) };
  }

  /** Many samples, one after another. */
  sample(options: SampleOptions): Samples {
    const rates = ratesOf(options), times = timesOf(this, options), count = times.length;
    const samples: Samples = { times, orientations: roomFor(4 * count) };
    for (const name of rates) samples[name] = roomFor(3 * count);
    if (this.hasPositions) samples.positions = roomFor(3 * count);
    for (let k = 0; k < count; ++k) {
      const motion = this.motion(times[k]);
      samples.orientations.set(motion.orientation, 4 * k);
      samples.angularVelocities?.set(motion.angularVelocity, 3 * k);
      samples.angularAccelerations?.set(motion.angularAcceleration, 3 * k);
      samples.angularJerks?.set(motion.angularJerk, 3 * k);
      samples.positions?.set(motion.position!, 3 * k);
    }
    return samples;
  }

  /** Frees its memory at once. It can be done twice. */
  dispose(): void {
    this.forgotten.unregister(this);
    this.engine.free('orispline_curve_free', this.address);
    this.address = 0;
  }

  /** The same at the end of a block: `using curve = ori.curve(…)`. */
  [Symbol.dispose](): void {
    this.dispose();
  }

  protected get handle(): Address {
    if (!this.address) throw new OrisplineError('disposed', 'found a curve that was disposed of, wanted one that was not');
    return this.address;
  }

  private told(first: number, count: number): number[] {
    const from = this.engine.numbersAt / 8 + first;
    return Array.from(this.engine.numbers.subarray(from, from + count));
  }
}
