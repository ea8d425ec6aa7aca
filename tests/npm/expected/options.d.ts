import type { Address, Engine } from './engine.js';
/** Options by their names, as the command has them: `{ tolerance: '0.1deg', values: true }`. Those that are undefined are not stated. */
export type Options = Record<string, string | number | boolean | undefined>;
/** Texts in the memory of the library, for the time of some work. */
export declare const withTexts: <Result>(engine: Engine, texts: string[], work: (list: Address, count: number) => Result) => Result;
/** Options as texts `name=value`, for the time of some work. */
export declare const withOptions: <Result>(engine: Engine, options: Options, work: (list: Address, count: number) => Result) => Result;
