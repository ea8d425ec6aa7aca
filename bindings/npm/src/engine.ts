// SPDX-License-Identifier: Apache-2.0
// The library as compiled code: its memory, its calls, its errors. The functions are those of bindings/c/orispline.h.
import { type ErrorCode, type ErrorPlace, OrisplineError, shown } from './errors.js';
import { mostMemory, noMemory } from './numbers.js';
import type { System } from './system.js';

type Call = (...values: number[]) => number;

/** A handle or an address in the memory of the library; 0 is none. */
export type Address = number;

/** How text that the library says becomes a sentence. */
export type Sentence = (message: string) => string;

const codes: ErrorCode[] = ['fault', 'bad_data', 'bad_argument', 'not_converged', 'bad_access', 'cancelled', 'no_memory', 'fault'];
const abi = 1;

/** Room for an error, a handle and the numbers of one motion. */
const room = 16 + 8 * 32;

/** The least that an engine asks for [bytes]. */
const leastMemory = 2 ** 16;

/** What is no number would be made one, by code of the caller or to 0. */
const checkNumber = (value: unknown): void => {
  if (typeof value !== 'number') throw new OrisplineError('bad_argument', `found ${shown(value)}, wanted a number`);
};

const otherModule = (): OrisplineError =>
  new OrisplineError('bad_data', 'found WebAssembly of something else, wanted the .wasm of this entry and version of the package', { option: 'wasm' });

export class Engine {
  /** Where a new error and a new handle go, and from where on numbers come back. */
  readonly errorAt: Address;
  readonly handleAt: Address;
  readonly numbersAt: Address;
  private readonly calls: Record<string, Call>;
  private readonly memory: WebAssembly.Memory;
  private readonly sentence: Sentence;
  private readonly lastWords: () => string | undefined;
  private readonly orientationCall: Call;
  private view = new Float64Array();
  private fault?: OrisplineError;

  /** `last`: a function that smaller modules lack. `system`: what the module asks for, if anything. */
  constructor(module: WebAssembly.Module, last: string, sentence: Sentence, system?: System) {
    let instance: WebAssembly.Instance;
    try {
      instance = new WebAssembly.Instance(module, system?.importsOf(module) ?? {});
    } catch (reason) {
      throw reason instanceof RangeError ? noMemory(leastMemory) : otherModule();
    }
    this.calls = instance.exports as Record<string, Call>;
    this.memory = instance.exports['memory'] as WebAssembly.Memory;
    if (system) system.memory = this.memory;
    this.lastWords = () => system?.said.trim();
    this.sentence = sentence;
    if (this.calls['orispline_abi']?.() !== abi || !this.has(last)) throw otherModule();
    this.calls['_initialize']?.();
    this.orientationCall = this.calls['orispline_curve_orientation'];
    this.errorAt = this.memoryFor(room);
    this.handleAt = this.errorAt + 8;
    this.numbersAt = this.errorAt + 16;
  }

  has(name: string): boolean {
    return name in this.calls;
  }

  /** All numbers of its memory. It is another array once the memory has grown, which empties this one, so nobody keeps it. */
  get numbers(): Float64Array {
    if (this.view.length === 0) this.view = new Float64Array(this.memory.buffer);
    return this.view;
  }

  /** What a function returns. A trap is a fault of the library, after which its memory is not to be trusted. */
  call(name: string, ...values: number[]): number {
    if (this.fault) throw this.fault;
    values.forEach(checkNumber);
    try {
      return this.calls[name](...values);
    } catch (trap) {
      throw this.failed(trap as Error);
    }
  }

  /** An orientation of a curve, to where numbers come back: without the list of values that `check` makes. */
  orientation(curve: Address, time: number, order: number): void {
    if (this.fault) throw this.fault;
    checkNumber(time);
    let code: number;
    try {
      code = this.orientationCall(curve, time, order, this.numbersAt, this.errorAt);
    } catch (trap) {
      throw this.failed(trap as Error);
    }
    if (code) throw this.error();
  }

  /** What a function does that gives a code, whose error is thrown. It takes the place of the error as its last value. */
  check(name: string, ...values: number[]): void {
    if (this.call(name, ...values, this.errorAt)) throw this.error();
  }

  /** A new handle, of a function whose last value but the error is where that goes. */
  made(name: string, ...values: number[]): Address {
    this.check(name, ...values, this.handleAt);
    return this.address(this.handleAt);
  }

  /** Bytes for numbers or a text, which whoever asks for them gives back. */
  memoryFor(bytes: number): Address {
    const address = bytes < mostMemory ? this.call('malloc', Math.max(bytes, 8)) >>> 0 : 0;
    if (!address) throw noMemory(bytes);
    return address;
  }

  /** Gives back memory or a handle. Nothing is done after a fault. */
  free(name: string, address: Address): void {
    if (!this.fault && address) this.call(name, address);
  }

  address(at: Address): Address {
    return new Uint32Array(this.memory.buffer, at, 1)[0];
  }

  bytes(at: Address, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.memory.buffer as ArrayBuffer, at, length);
  }

  words(at: Address, length: number): Uint32Array<ArrayBuffer> {
    return new Uint32Array(this.memory.buffer as ArrayBuffer, at, length);
  }

  /** A text of the library, which ends in a zero. */
  text(at: Address): string {
    const bytes = new Uint8Array(this.memory.buffer, at >>> 0);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  // In its memory, for the time of some work:

  withText<Result>(text: string, work: (at: Address) => Result): Result {
    if (text.includes('\0')) throw new OrisplineError('bad_argument', `found ${JSON.stringify(text)}, wanted a text without a zero in it`);
    return this.withBytes(new TextEncoder().encode(`${text}\0`), work);
  }

  withBytes<Result>(bytes: Uint8Array, work: (at: Address) => Result): Result {
    return this.withRoom(bytes.length, (at) => (this.bytes(at, bytes.length).set(bytes), work(at)));
  }

  withNumbers<Result>(numbers: Float64Array, work: (at: Address) => Result): Result {
    return this.withRoom(8 * numbers.length, (at) => (this.numbers.set(numbers, at / 8), work(at)));
  }

  withWords<Result>(words: number[], work: (at: Address) => Result): Result {
    return this.withRoom(4 * words.length, (at) => (this.words(at, words.length).set(words), work(at)));
  }

  withRoom<Result>(bytes: number, work: (at: Address) => Result): Result {
    const at = this.memoryFor(bytes);
    try {
      return work(at);
    } finally {
      this.free('free', at);
    }
  }

  /** A text that a function makes, whose last value but the error is where it goes. */
  toldText(name: string, ...values: number[]): string {
    const at = this.made(name, ...values);
    try {
      return this.text(at);
    } finally {
      this.free('orispline_text_free', at);
    }
  }

  /** Of 64 bits. */
  wholeNumber(at: Address): number {
    return Number(new BigInt64Array(this.memory.buffer, at, 1)[0]);
  }

  private error(): OrisplineError {
    const error = this.address(this.errorAt);
    const about = (part: string): string => this.text(this.call(`orispline_error_${part}`, error));
    const index = (part: string): number => (this.has(`orispline_error_${part}`) ? Number(this.call(`orispline_error_${part}`, error)) : -1);
    const place: ErrorPlace = {}, key = index('key'), line = index('line'), column = index('column'), option = about('option'), remedy = about('remedy');
    if (key >= 0) place.key = key;
    if (line >= 0) place.line = line;
    if (column >= 0) place.column = column;
    if (option) place.option = option;
    if (remedy) place.remedy = remedy;
    const message = this.sentence(about('message')), code = codes[this.call('orispline_error_code', error)];
    this.free('orispline_error_free', error);
    return new OrisplineError(code, `${key < 0 ? '' : `key ${key}: `}${option ? `${option}: ` : ''}${message}`, place);
  }

  private failed(trap: Error): OrisplineError {
    // Compiled code that gets no memory ends too. It asks for more than is left, which is seen where much is used.
    const used = this.memory.buffer.byteLength;
    this.fault = used > mostMemory / 2
      ? new OrisplineError('no_memory', `found no memory left beside the ${used} bytes in use, wanted fewer curves at once, or larger ones disposed of; load() gives a sound library anew`)
      : new OrisplineError('fault', `found a fault of orispline (${this.lastWords() || trap.message}), wanted none: please report it; load() gives a sound one anew`);
    return this.fault;
  }
}
