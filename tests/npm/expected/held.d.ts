/// <reference lib="esnext.disposable" preserve="true" />
import type { Address, Engine } from './engine.js';
/** What is freed some time after it was forgotten: the function that frees it, and its handle. */
export type Forgotten = FinalizationRegistry<[free: string, handle: Address]>;
/** Something in the memory of the library, by its handle. It is freed where it is disposed of, or some time after it was forgotten. */
export declare class Held {
    protected readonly engine: Engine;
    private address;
    private readonly forgotten;
    private readonly kind;
    constructor(engine: Engine, forgotten: Forgotten, kind: 'keys' | 'skeleton', address: Address);
    /** Frees its memory at once. It can be done twice. */
    dispose(): void;
    [Symbol.dispose](): void;
    /** For calls of the library that made it: to another one, with a memory of its own, it says nothing. */
    handleIn(engine: Engine): Address;
    protected get handle(): Address;
    private get free();
}
