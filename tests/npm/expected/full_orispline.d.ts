import type { Engine } from './engine.js';
import { KeyTrack } from './key_track.js';
import { type KeyData } from './keys.js';
import { Orispline } from './orispline.js';
import type { Progress, System } from './system.js';
import { WholeCurve } from './whole_curve.js';
/** Options by their names, as the command has them: `{ tolerance: '0.1deg', values: true }`. Those that are undefined are not stated. */
export type Options = Record<string, string | number | boolean | undefined>;
/** Keys or recordings, by the name that a task has for them; several where it takes several. */
export type TaskInputs = Record<string, KeyData | KeyTrack | (KeyData | KeyTrack)[]>;
/** How a task is run. */
export interface RunOptions {
    /** Where it ends the task, that throws an error with the code `cancelled`, unless all was done; what it throws comes out as it is. */
    progress?: Progress;
}
/** What is to be said of a result; docs/inspect-json.md has all members. */
export interface Warning {
    code: string;
    message: string;
    key?: number;
    line?: number;
    [number: string]: unknown;
}
/** A file of keys. */
export interface KeyFile {
    bytes: Uint8Array;
    warnings: Warning[];
}
/** What a task found. */
export interface Outcome {
    /** As the command's `--json` has it. */
    document: Record<string, unknown>;
    /** Sentences for people. */
    summary: string;
    warnings: Warning[];
    /** The keys that it made. */
    tracks: KeyTrack[];
}
/** The library with files and tasks. */
export declare class FullOrispline extends Orispline<WholeCurve> {
    private readonly forgottenKeys;
    private readonly system;
    constructor(engine: Engine, system: System);
    /** The keys of a file in memory. Its name says what it is: `keys.csv`, `walk.bvh`. */
    read(bytes: ArrayBuffer | ArrayBufferView | string, name: string, options?: Options): KeyTrack;
    /** A file of keys, whose name says of which format. */
    write(keys: KeyData | KeyTrack, name: string, options?: Options): KeyFile;
    /** The tasks with their inputs, options and results, as `orispline tasks --json` has them. */
    tasks(): Record<string, unknown>[];
    /** Runs a task: `run('reduce', { recording }, { tolerance: '0.1deg' })`. It takes as long as it takes: where that matters, run it in a worker. */
    run(task: string, inputs: TaskInputs, options?: Options, running?: RunOptions): Outcome;
    private found;
    private track;
    private withTrack;
    /** Texts `name=value`, for the time of some work. */
    private withOptions;
}
