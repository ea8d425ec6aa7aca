// SPDX-License-Identifier: Apache-2.0
/// <reference lib="esnext.disposable" preserve="true" />
import type { Address, Engine } from './engine.js';
import { OrisplineError, badArgument } from './errors.js';

/** What is freed some time after it was forgotten: the function that frees it, and its handle. */
export type Forgotten = FinalizationRegistry<[free: string, handle: Address]>;

/** Something in the memory of the library, by its handle. It is freed where it is disposed of, or some time after it was forgotten. */
export class Held {
  protected readonly engine: Engine;
  private address: Address;
  private readonly forgotten: Forgotten;
  private readonly kind: 'keys' | 'skeleton';

  constructor(engine: Engine, forgotten: Forgotten, kind: 'keys' | 'skeleton', address: Address) {
    this.engine = engine;
    this.forgotten = forgotten;
    this.kind = kind;
    this.address = address;
    forgotten.register(this, [this.free, address], this);
  }

  /** Frees its memory at once. It can be done twice. */
  dispose(): void {
    this.forgotten.unregister(this);
    this.engine.free(this.free, this.address);
    this.address = 0;
  }

  [Symbol.dispose](): void {
    this.dispose();
  }

  /** For calls of the library that made it: to another one, with a memory of its own, it says nothing. */
  handleIn(engine: Engine): Address {
    if (engine !== this.engine)
      throw badArgument(this.kind, this.kind === 'keys' ? 'found some that another load() made, wanted those of this one' : 'found one that another load() made, wanted one of this one');
    return this.handle;
  }

  protected get handle(): Address {
    if (!this.address)
      throw new OrisplineError('disposed', this.kind === 'keys' ? 'found keys that were disposed of, wanted some that were not' : 'found a skeleton that was disposed of, wanted one that was not');
    return this.address;
  }

  private get free(): string {
    return this.kind === 'keys' ? 'orispline_keys_free' : 'orispline_value_free';
  }
}
