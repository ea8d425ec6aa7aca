// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { textOf } from './errors.js';
import { type Forgotten, Held } from './held.js';
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
export class KeyTrack extends Held {
  /** Of an `Orispline`, by its `read` or its `run`. */
  constructor(engine: Engine, forgotten: Forgotten, address: Address) {
    super(engine, forgotten, 'keys', address);
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
}
