// SPDX-License-Identifier: Apache-2.0
import { Curve, type SampleOptions, type Samples, ratesOf, timesOf } from './curve.js';
import { badArgument, optionsOf, shown } from './errors.js';
import { numbersOf } from './numbers.js';
import type { BakedFile } from './player.js';

/** How far a rate jumps at the keys. */
export interface Jump {
  /** In the unit of the rate. */
  largest: number;
  /** To the largest rate of the curve; 0 where every jump is rounding. */
  relative: number;
  /** Where. */
  key: number;
}

/** Which rates are continuous at the keys. */
export interface Continuity {
  /** No rate up to this order jumps: 0 to 3; -1 where the orientation itself jumps. */
  order: number;
  /** [rad/s]. */
  angularVelocity: Jump;
  /** [rad/s²]. */
  angularAcceleration: Jump;
  /** [rad/s³]. */
  angularJerk: Jump;
}

/** The largest value of a rate that was found, and where [s]. It is nowhere above `bound`, which is absent where no bound is known. */
export interface Peak {
  value: number;
  time: number;
  bound?: number;
}

export interface Peaks {
  /** [rad/s]. */
  angularVelocity: Peak;
  /** [rad/s²]. */
  angularAcceleration: Peak;
  /** [N m], with an inertia. */
  torque?: Peak;
}

const asDouble = 0, position = 7;

/** A curve by any method. */
export class WholeCurve extends Curve {
  /** Samples in bulk, which is many times faster than one after another. */
  override sample(options: SampleOptions): Samples {
    const rates = ratesOf(options), times = timesOf(this, options), count = times.length;
    const wanted = [{ name: 'orientations', quantity: 0, width: 4 }, ...rates.map((name, k) => ({ name, quantity: k + 1, width: 3 }))];
    if (this.hasPositions) wanted.push({ name: 'positions', quantity: position, width: 3 });
    const { engine } = this, inRow = wanted.reduce((sum, { width }) => sum + width, 0);
    return engine.withRoom(8 * inRow * count, (numbers) => {
      let next = numbers;
      const places = wanted.map(({ name, quantity, width }) => {
        const from = next, length = width * count;
        next += 8 * length;
        return { name, quantity, from, length };
      });
      const outputs = places.flatMap(({ quantity, from }) => [quantity, asDouble, from, 0]);
      engine.withWords(outputs, (at) => this.fill(options, times, at, wanted.length));
      // Unlike slice, the constructor does not clear the memory that it is about to fill.
      const found = places.map(({ name, from, length }) => [name, new Float64Array(engine.numbers.subarray(from / 8, from / 8 + length))]);
      return { times, ...Object.fromEntries(found) } as Samples;
    });
  }

  /** Which rates are continuous at the keys, and how far the others jump. */
  continuity(): Continuity {
    const { engine } = this, at = engine.numbersAt;
    engine.check('orispline_curve_continuity', this.handle, at);
    const jump = (k: number): Jump => {
      const [largest, relative] = engine.numbers.subarray(at / 8 + k, at / 8 + k + 2);
      return { largest, relative, key: engine.wholeNumber(at + 8 * (k + 2)) };
    };
    return { order: engine.wholeNumber(at), angularVelocity: jump(1), angularAcceleration: jump(4), angularJerk: jump(7) };
  }

  /** The order that is reached at each key: 3 at the ends, but for those of a loop; -1 where the orientation jumps before the next key. */
  orders(): Int8Array {
    const { engine } = this, count = this.keyCount;
    return engine.withRoom(4 * count, (at) => {
      engine.check('orispline_curve_orders', this.handle, at, count);
      return Int8Array.from(engine.words(at, count), (order) => order | 0); // whose sign is the highest bit
    });
  }

  /** The largest rates that were found; with `inertia`, the nine numbers of a symmetric matrix [kg m²], the torque too. */
  peaks(options: { inertia?: ArrayLike<number> } = {}): Peaks {
    const { inertia } = optionsOf('options', options), matrix = inertia === undefined ? undefined : numbersOf('inertia', inertia);
    if (matrix && matrix.length !== 9) throw badArgument('inertia', `found ${matrix.length} numbers, wanted 9`);
    const { engine } = this, at = engine.numbersAt;
    const find = (numbers: number) => engine.check('orispline_curve_bounded_peaks', this.handle, numbers, at, at + 48);
    if (matrix) engine.withNumbers(matrix, find);
    else find(0);
    const peak = (k: number): Peak => {
      const [value, time] = engine.numbers.subarray(at / 8 + 2 * k), bound = engine.numbers[at / 8 + 6 + k];
      return Number.isNaN(bound) ? { value, time } : { value, time, bound };
    };
    const found: Peaks = { angularVelocity: peak(0), angularAcceleration: peak(1) };
    return matrix ? { ...found, torque: peak(2) } : found;
  }

  /** What `orispline/player` plays: the .json that `orispline bake` writes, with the times of the keys. The tolerances are in rad, and in m for positions. */
  bake(options: { tolerance: number; positionTolerance?: number }): BakedFile {
    const { tolerance, positionTolerance = 1e-3 } = optionsOf('options', options);
    if (typeof tolerance !== 'number') throw badArgument('tolerance', `found ${shown(tolerance)}, wanted an angle [rad]`);
    if (typeof positionTolerance !== 'number') throw badArgument('positionTolerance', `found ${shown(positionTolerance)}, wanted a length [m]`);
    return JSON.parse(this.engine.toldText('orispline_bake_text', this.handle, tolerance, positionTolerance)) as BakedFile;
  }

  /** The text of its method, with its settings. */
  get method(): string {
    return this.engine.toldText('orispline_curve_method', this.handle);
  }

  private fill(options: SampleOptions, times: Float64Array, outputs: number, outputCount: number): void {
    const { engine } = this, beyond = 0, threads = 1, count = times.length;
    if (options.times)
      engine.withNumbers(times, (at) => engine.check('orispline_sample_at', this.handle, at, count, this.orderNumber, beyond, threads, outputs, outputCount));
    else engine.check('orispline_sample_even', this.handle, options.start ?? this.start, options.step!, count, this.orderNumber, beyond, threads, outputs, outputCount);
  }
}
