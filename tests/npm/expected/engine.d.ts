import type { System } from './system.js';
/** A handle or an address in the memory of the library; 0 is none. */
export type Address = number;
/** How text that the library says becomes a sentence. */
export type Sentence = (message: string) => string;
export declare class Engine {
    /** Where a new error and a new handle go, and from where on numbers come back. */
    readonly errorAt: Address;
    readonly handleAt: Address;
    readonly numbersAt: Address;
    private readonly calls;
    private readonly memory;
    private readonly sentence;
    private readonly lastWords;
    private readonly orientationCall;
    private view;
    private fault?;
    /** `last`: a function that smaller modules lack. `system`: what the module asks for, if anything. */
    constructor(module: WebAssembly.Module, last: string, sentence: Sentence, system?: System);
    has(name: string): boolean;
    /** All numbers of its memory. It is another array once the memory has grown, which empties this one, so nobody keeps it. */
    get numbers(): Float64Array;
    /** What a function returns. A trap is a fault of the library, after which its memory is not to be trusted. */
    call(name: string, ...values: number[]): number;
    /** An orientation of a curve, to where numbers come back: without the list of values that `check` makes. */
    orientation(curve: Address, time: number, order: number): void;
    /** What a function does that gives a code, whose error is thrown. It takes the place of the error as its last value. */
    check(name: string, ...values: number[]): void;
    /** A new handle, of a function whose last value but the error is where that goes. */
    made(name: string, ...values: number[]): Address;
    /** Bytes for numbers or a text, which whoever asks for them gives back. */
    memoryFor(bytes: number): Address;
    /** Gives back memory or a handle. Nothing is done after a fault. */
    free(name: string, address: Address): void;
    address(at: Address): Address;
    bytes(at: Address, length: number): Uint8Array<ArrayBuffer>;
    words(at: Address, length: number): Uint32Array<ArrayBuffer>;
    /** A text of the library, which ends in a zero. */
    text(at: Address): string;
    withText<Result>(text: string, work: (at: Address) => Result): Result;
    withBytes<Result>(bytes: Uint8Array, work: (at: Address) => Result): Result;
    withNumbers<Result>(numbers: Float64Array, work: (at: Address) => Result): Result;
    withWords<Result>(words: number[], work: (at: Address) => Result): Result;
    withRoom<Result>(bytes: number, work: (at: Address) => Result): Result;
    /** A text that a function makes, whose last value but the error is where it goes. */
    toldText(name: string, ...values: number[]): string;
    /** Of 64 bits. */
    wholeNumber(at: Address): number;
    private error;
    private failed;
}
