import type { Engine } from './engine.js';
import { KeyTrack } from './key_track.js';
import { type Options } from './options.js';
import { Orispline } from './orispline.js';
import { Skeleton } from './skeleton.js';
import type { Progress, System } from './system.js';
import type { InputsOf, KeyInput, OptionsOf, RateData, TaskInputs } from './task_values.js';
import { WholeCurve } from './whole_curve.js';
import { type KeyFile, type Warning } from './written.js';
export type { KeyFile, Options, TaskInputs, Warning };
/** How a task is run. */
export interface RunOptions {
    /** Where it ends the task, that throws an error with the code `cancelled`, unless all was done; what it throws comes out as it is. */
    progress?: Progress;
}
/** What a task found. */
export interface Outcome {
    /** As the command's `--json` has it. */
    document: Record<string, unknown>;
    /** Sentences for people. */
    summary: string;
    /** The summary in one line; empty where a task has none. */
    line: string;
    warnings: Warning[];
    /** The keys that it made. */
    tracks: KeyTrack[];
    /** The rates of gyros that it made. */
    rates: RateData[];
    /** The skeletons that it made. */
    skeletons: Skeleton[];
}
/** The library with files and tasks. */
export declare class FullOrispline extends Orispline<WholeCurve> {
    private readonly forgottenHandles;
    private readonly system;
    constructor(engine: Engine, system: System);
    /** The keys of a file in memory. Its name says what it is: `keys.csv`, `walk.bvh`. */
    read(bytes: ArrayBuffer | ArrayBufferView | string, name: string, options?: Options): KeyTrack;
    /** A file of keys, whose name says of which format. */
    write(keys: KeyInput, name: string, options?: Options): KeyFile;
    /** The tasks with their inputs, options and results, as `orispline tasks --json` has them. */
    tasks(): Record<string, unknown>[];
    /** Runs a task: `run('reduce', { recording }, { tolerance: '0.1deg' })`. It takes as long as it takes: where that matters, run it in a worker. */
    run<Task extends string>(task: Task, inputs: InputsOf<Task>, options?: OptionsOf<Task>, running?: RunOptions): Outcome;
    private found;
    /** Rates or a skeleton that a task has made. */
    private add;
    private ratesOf;
    private track;
    private withTrack;
    /** What a task takes, in the memory of the library for the time of some work. */
    private withValue;
    private madeOf;
    private madeOfKeys;
    private madeOfFile;
    private madeOfRates;
}
