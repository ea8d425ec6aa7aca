import type { Address, Engine } from './engine.js';
import { type Options } from './options.js';
/** What is to be said of a result; docs/inspect-json.md has all members. */
export interface Warning {
    code: string;
    message: string;
    key?: number;
    line?: number;
    [number: string]: unknown;
}
/** A file that was written. */
export interface KeyFile {
    bytes: Uint8Array;
    warnings: Warning[];
}
/** What a function writes of a handle, as a file of that name. */
export declare const written: (engine: Engine, call: string, handle: Address, name: string, options: Options) => KeyFile;
