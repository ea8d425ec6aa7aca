// SPDX-License-Identifier: Apache-2.0
/// <reference lib="esnext.disposable" preserve="true" />
import type { Address, Engine } from './engine.js';
import { OrisplineError, badArgument, textOf } from './errors.js';
import { type KeyData, type Order, orderOf } from './keys.js';

/** What keys are, and what reading them found: docs/c.md has all members. */
export interface KeyInfo {
  count: number;
  columns: { name: string; width: number }[];
  name: string;
  /** What the times count from [s]. */
  epoch: string;
  /** The method that they are for. */
  method: string | null;
  [member: string]: unknown;
}

/** Keys with all that a file or a task has said of them. They are freed where they are disposed of, or some time after they were forgotten. */
export class KeyTrack {
  private address: Address;
  private readonly engine: Engine;
  private readonly forgotten: FinalizationRegistry<Address>;

  /** Of an `Orispline`, by its `read` or its `run`. */
  constructor(engine: Engine, forgotten: FinalizationRegistry<Address>, address: Address) {
    this.engine = engine;
    this.forgotten = forgotten;
    this.address = address;
    forgotten.register(this, address, this);
  }

  get info(): KeyInfo {
    return JSON.parse(this.engine.toldText('orispline_keys_json', this.handle));
  }

  /** A column by its name: `times`, `positions`, a setting such as `tension`. */
  column(name: string, order: Order = 'xyzw'): Float64Array {
    textOf('name', name);
    const { count, columns } = this.info, { engine } = this;
    const width = columns.find((column) => column.name === name)?.width ?? 1, length = width * count, at = engine.memoryFor(8 * length);
    try {
      engine.withText(name, (text) => engine.check('orispline_keys_column', this.handle, text, orderOf(order), at, length));
      return engine.numbers.slice(at / 8, at / 8 + length);
    } finally {
      engine.free('free', at);
    }
  }

  /** As plain arrays, for `curve`. */
  data(order: Order): KeyData {
    const has = new Set(this.info.columns.map(({ name }) => name));
    const data: KeyData = { times: this.column('times'), orientations: this.column('orientations', order), order };
    if (has.has('positions')) data.positions = this.column('positions');
    if (has.has('angular_velocities')) data.angularVelocities = this.column('angular_velocities');
    if (has.has('angular_accelerations')) data.angularAccelerations = this.column('angular_accelerations');
    if (has.has('angular_jerks')) data.angularJerks = this.column('angular_jerks');
    return data;
  }

  /** Frees their memory at once. It can be done twice. */
  dispose(): void {
    this.forgotten.unregister(this);
    this.engine.free('orispline_keys_free', this.address);
    this.address = 0;
  }

  [Symbol.dispose](): void {
    this.dispose();
  }

  /** For calls of the library that made them: to another one, with a memory of its own, it says nothing. */
  handleIn(engine: Engine): Address {
    if (engine !== this.engine) throw badArgument('keys', 'found some that another load() made, wanted those of this one');
    return this.handle;
  }

  private get handle(): Address {
    if (!this.address) throw new OrisplineError('disposed', 'found keys that were disposed of, wanted some that were not');
    return this.address;
  }
}
