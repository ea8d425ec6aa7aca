// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { badArgument, optionsOf, shown, textOf } from './errors.js';
import { KeyTrack } from './key_track.js';
import { type KeyData, checkedKeys, withKeys } from './keys.js';
import { Orispline } from './orispline.js';
import type { Progress, System } from './system.js';
import { bytesOf } from './wasm.js';
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
export class FullOrispline extends Orispline<WholeCurve> {
  private readonly forgottenKeys: FinalizationRegistry<Address>;
  private readonly system: System;

  constructor(engine: Engine, system: System) {
    super(engine, WholeCurve, () => JSON.parse(engine.toldText('orispline_methods_json')));
    this.system = system;
    this.forgottenKeys = new FinalizationRegistry((keys) => engine.free('orispline_keys_free', keys));
  }

  /** The keys of a file in memory. Its name says what it is: `keys.csv`, `walk.bvh`. */
  read(bytes: ArrayBuffer | ArrayBufferView | string, name: string, options: Options = {}): KeyTrack {
    const { engine } = this, content = typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytesOf('bytes', bytes);
    return this.track(engine.withBytes(content, (at) => engine.withText(textOf('name', name), (text) => this.withOptions(options, (list, count) =>
      engine.made('orispline_keys_read', at, content.length, text, list, count)))));
  }

  /** A file of keys, whose name says of which format. */
  write(keys: KeyData | KeyTrack, name: string, options: Options = {}): KeyFile {
    const { engine } = this, sizeAt = engine.numbersAt, warningsAt = sizeAt + 8;
    return this.withTrack(keys, (track) => engine.withText(textOf('name', name), (text) => this.withOptions(options, (list, count) => {
      engine.check('orispline_keys_write', track, text, list, count, engine.handleAt, sizeAt, warningsAt);
      const [at, size, warnings] = [engine.handleAt, sizeAt, warningsAt].map((place) => engine.address(place));
      try {
        return { bytes: engine.bytes(at, size).slice(), warnings: JSON.parse(engine.text(warnings)) };
      } finally {
        engine.free('orispline_text_free', at);
        engine.free('orispline_text_free', warnings);
      }
    })));
  }

  /** The tasks with their inputs, options and results, as `orispline tasks --json` has them. */
  tasks(): Record<string, unknown>[] {
    return JSON.parse(this.engine.toldText('orispline_tasks_json'));
  }

  /** Runs a task: `run('reduce', { recording }, { tolerance: '0.1deg' })`. It takes as long as it takes: where that matters, run it in a worker. */
  run(task: string, inputs: TaskInputs, options: Options = {}, running: RunOptions = {}): Outcome {
    const { progress } = optionsOf('running', running);
    return this.system.showing(progress, () => this.found(task, inputs, options, progress));
  }

  private found(task: string, inputs: TaskInputs, options: Options, progress: Progress | undefined): Outcome {
    const { engine } = this, given = Object.entries(optionsOf('inputs', inputs)).flatMap(([name, keys]) => (Array.isArray(keys) ? keys : [keys]).map((one) => ({ name, keys: one as KeyData | KeyTrack })));
    /** Puts the inputs into memory one by one, so that each is freed again. */
    const withInputs = (k: number, rows: number[]): Address => {
      if (k < given.length)
        return this.withTrack(given[k].keys, (track) => engine.withText(given[k].name, (name) => withInputs(k + 1, [...rows, name, track])));
      return engine.withWords(rows, (table) => engine.withText(textOf('task', task), (name) => this.withOptions(options, (list, count) =>
        engine.made('orispline_task_run', name, table, given.length, list, count, progress ? engine.call('orispline_npm_progress_address') : 0, 0))));
    };
    const outcome = withInputs(0, []);
    try {
      const told = (part: string): string => engine.text(engine.call(`orispline_outcome_${part}`, outcome));
      const tracks = Array.from({ length: engine.call('orispline_outcome_track_count', outcome) }, (_, k) => this.track(engine.made('orispline_outcome_track', outcome, k)));
      return { document: JSON.parse(told('document')), summary: told('summary'), warnings: JSON.parse(told('warnings')), tracks };
    } finally {
      engine.free('orispline_outcome_free', outcome);
    }
  }

  private track(address: Address): KeyTrack {
    return new KeyTrack(this.engine, this.forgottenKeys, address);
  }

  private withTrack<Result>(keys: KeyData | KeyTrack, work: (track: Address) => Result): Result {
    return keys instanceof KeyTrack ? work(keys.handleIn(this.engine)) : withKeys(this.engine, checkedKeys(keys), work);
  }

  /** Texts `name=value`, for the time of some work. */
  private withOptions<Result>(options: Options, work: (list: Address, count: number) => Result): Result {
    const texts = Object.entries(optionsOf('options', options)).flatMap(([name, value]) => {
      if (value === undefined) return [];
      if (!['string', 'number', 'boolean'].includes(typeof value)) throw badArgument(name, `found ${shown(value)}, wanted a text, a number or a flag`);
      return [`${name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`)}=${value}`];
    });
    const withTexts = (k: number, places: number[]): Result =>
      k < texts.length ? this.engine.withText(texts[k], (at) => withTexts(k + 1, [...places, at])) : this.engine.withWords(places, (list) => work(list, places.length));
    return withTexts(0, []);
  }
}
