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
    private readonly orientationCall;
    private view;
    private fault?;
    constructor(module: WebAssembly.Module, sentence: Sentence);
    has(name: string): boolean;
    /** All numbers of its memory. It is another array once the memory has grown, so nobody keeps it. */
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
    /** A text in its memory, for the time of some work. */
    withText<Result>(text: string, work: (at: Address) => Result): Result;
    /** Numbers in its memory, for the time of some work. */
    withNumbers<Result>(numbers: ArrayLike<number>, work: (at: Address) => Result): Result;
    private error;
    private failed;
}
