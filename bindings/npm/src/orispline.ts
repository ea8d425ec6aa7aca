// SPDX-License-Identifier: Apache-2.0
import { Curve } from './curve.js';
import type { Address, Engine } from './engine.js';
import type { KeyData } from './keys.js';
import type { Settings } from './method.js';

/** A number of a method that may be set. */
export interface ParameterInfo {
  name: string;
  default: number;
  min: number;
  max: number;
  /** Whether each key may have its own. */
  per_key: boolean;
  /** The number of keys beyond either end that may have their own too. */
  ghosts: number;
  /** Whether it may be a symmetric matrix of 3 or 6 numbers. */
  tensor: boolean;
  /** Of the number, which a text may state with another one behind it, such as `0.1deg`; null for a plain number. */
  unit: string | null;
}

/** What the registry says of a method; docs/inspect-json.md has all members. */
export interface MethodInfo {
  name: string;
  title: string;
  source: string;
  /** The order of continuity in time, on even keys and on any. */
  continuity_uniform: number;
  continuity_uneven: number;
  min_keys: number;
  closes: boolean;
  parameters: ParameterInfo[];
  /** The rules for the ends, the usual one first. */
  ends: string[];
  [member: string]: unknown;
}

/** The library, loaded. */
export class Orispline<Made extends Curve = Curve> {
  protected readonly engine: Engine;
  private readonly forgotten: FinalizationRegistry<Address>;
  private readonly kind: new (...about: ConstructorParameters<typeof Curve>) => Made;
  private readonly list: () => MethodInfo[];

  /** Of `load()`. */
  constructor(engine: Engine, kind: new (...about: ConstructorParameters<typeof Curve>) => Made, list: () => MethodInfo[]) {
    this.engine = engine;
    this.kind = kind;
    this.list = list;
    this.forgotten = new FinalizationRegistry((curve) => engine.free('orispline_curve_free', curve));
  }

  /** The curve of a method through keys: `curve('timed-c2', { times, orientations, order: 'xyzw' }, { tension: 0.6 })`. */
  curve(method: string, keys: KeyData, settings: Settings = {}): Made {
    return new this.kind(this.engine, this.forgotten, method, keys, settings);
  }

  /** What there is to choose from. */
  methods(): MethodInfo[] {
    return this.list();
  }
}
