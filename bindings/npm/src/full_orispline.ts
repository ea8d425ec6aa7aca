// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { badArgument, optionsOf, shown, textOf } from './errors.js';
import type { Forgotten } from './held.js';
import { KeyTrack } from './key_track.js';
import { type KeyData, checkedKeys, withKeys } from './keys.js';
import { numbersOf } from './numbers.js';
import { type Options, withOptions, withTexts } from './options.js';
import { Orispline } from './orispline.js';
import { Skeleton } from './skeleton.js';
import type { Progress, System } from './system.js';
import type { InputsOf, KeyInput, OptionsOf, RateData, SceneFile, TaskInput, TaskInputs } from './task_values.js';
import { bytesOf } from './wasm.js';
import { WholeCurve } from './whole_curve.js';
import { type KeyFile, type Warning, written } from './written.js';

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

const kindOfSkeletons = 3;

const contentOf = (bytes: ArrayBuffer | ArrayBufferView | string): Uint8Array => (typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytesOf('bytes', bytes));

const textsOf = ({ clips = [], dropDuplicates = false, salvage = false, restFrame, signs }: SceneFile): string[] => {
  if (!Array.isArray(clips)) throw badArgument('clips', `found ${shown(clips)}, wanted names`);
  return [...clips.map((clip) => `clip=${textOf('clips', clip)}`), ...(dropDuplicates ? ['drop_duplicates'] : []), ...(salvage ? ['salvage'] : []), ...(restFrame === undefined ? [] : [`rest_frame=${restFrame}`]), ...(signs === undefined ? [] : [`signs=${textOf('signs', signs)}`])];
};

/** The library with files and tasks. */
export class FullOrispline extends Orispline<WholeCurve> {
  private readonly forgottenHandles: Forgotten;
  private readonly system: System;

  constructor(engine: Engine, system: System) {
    super(engine, WholeCurve, () => JSON.parse(engine.toldText('orispline_methods_json')));
    this.system = system;
    this.forgottenHandles = new FinalizationRegistry(([free, handle]) => engine.free(free, handle));
  }

  /** The keys of a file in memory. Its name says what it is: `keys.csv`, `walk.bvh`. */
  read(bytes: ArrayBuffer | ArrayBufferView | string, name: string, options: Options = {}): KeyTrack {
    const { engine } = this, content = contentOf(bytes);
    return this.track(engine.withBytes(content, (at) => engine.withText(textOf('name', name), (text) => withOptions(engine, options, (list, count) =>
      engine.made('orispline_keys_read', at, content.length, text, list, count)))));
  }

  /** A file of keys, whose name says of which format. */
  write(keys: KeyInput, name: string, options: Options = {}): KeyFile {
    return this.withTrack(keys, (track) => written(this.engine, 'orispline_keys_write', track, name, options));
  }

  /** The tasks with their inputs, options and results, as `orispline tasks --json` has them. */
  tasks(): Record<string, unknown>[] {
    return JSON.parse(this.engine.toldText('orispline_tasks_json'));
  }

  /** Runs a task: `run('reduce', { recording }, { tolerance: '0.1deg' })`. It takes as long as it takes: where that matters, run it in a worker. */
  run<Task extends string>(task: Task, inputs: InputsOf<Task>, options?: OptionsOf<Task>, running: RunOptions = {}): Outcome {
    const { progress } = optionsOf('running', running);
    return this.system.showing(progress, () => this.found(task, inputs, options as Options, progress));
  }

  private found(task: string, inputs: TaskInputs, options: Options, progress: Progress | undefined): Outcome {
    const { engine } = this, given = Object.entries(optionsOf('inputs', inputs)).flatMap(([name, values]) => [values].flat().map((value) => ({ name, value }))).filter(({ value }) => value !== undefined);
    /** Puts the inputs into memory one by one, so that each is freed again. */
    const withInputs = (k: number, rows: number[]): Address => {
      if (k < given.length)
        return this.withValue(given[k].value as TaskInput, (value) => engine.withText(given[k].name, (name) => withInputs(k + 1, [...rows, name, value])));
      return engine.withWords(rows, (table) => engine.withText(textOf('task', task), (name) => withOptions(engine, options, (list, count) =>
        engine.made('orispline_task_run_with', name, table, given.length, list, count, progress ? engine.call('orispline_npm_progress_address') : 0, 0))));
    };
    const outcome = withInputs(0, []);
    try {
      const told = (part: string): string => engine.text(engine.call(`orispline_outcome_${part}`, outcome));
      const tracks = Array.from({ length: engine.call('orispline_outcome_track_count', outcome) }, (_, k) => this.track(engine.made('orispline_outcome_track', outcome, k)));
      const found: Outcome = { document: JSON.parse(told('document')), summary: told('summary'), line: told('line'), warnings: JSON.parse(told('warnings')), tracks, rates: [], skeletons: [] };
      for (let k = tracks.length; k < engine.call('orispline_outcome_value_count', outcome); ++k) this.add(found, engine.made('orispline_outcome_value', outcome, k));
      return found;
    } finally {
      engine.free('orispline_outcome_free', outcome);
    }
  }

  /** Rates or a skeleton that a task has made. */
  private add(found: Outcome, value: Address): void {
    const { engine } = this;
    if (engine.call('orispline_value_kind', value) === kindOfSkeletons) {
      found.skeletons.push(new Skeleton(engine, this.forgottenHandles, value));
      return;
    }
    try {
      found.rates.push(this.ratesOf(value));
    } finally {
      engine.free('orispline_value_free', value);
    }
  }

  private ratesOf(value: Address): RateData {
    const { engine } = this, count = engine.call('orispline_value_count', value);
    return engine.withRoom(32 * count, (at) => {
      engine.check('orispline_value_rates', value, at, at + 8 * count, count);
      const [times, rates] = [engine.numbers.slice(at / 8, at / 8 + count), engine.numbers.slice(at / 8 + count, at / 8 + 4 * count)];
      return { times, rates, epoch: JSON.parse(engine.toldText('orispline_value_json', value)).epoch };
    });
  }

  private track(address: Address): KeyTrack {
    return new KeyTrack(this.engine, this.forgottenHandles, address);
  }

  private withTrack<Result>(keys: KeyData | KeyTrack, work: (track: Address) => Result): Result {
    return keys instanceof KeyTrack ? work(keys.handleIn(this.engine)) : withKeys(this.engine, checkedKeys(keys), work);
  }

  /** What a task takes, in the memory of the library for the time of some work. */
  private withValue<Result>(input: TaskInput, work: (value: Address) => Result): Result {
    if (input instanceof Skeleton) return work(input.handleIn(this.engine));
    const value = this.madeOf(input);
    try {
      return work(value);
    } finally {
      this.engine.free('orispline_value_free', value);
    }
  }

  private madeOf(input: KeyInput | RateData | SceneFile): Address {
    if (typeof input !== 'object' || !input || input instanceof KeyTrack) return this.madeOfKeys(input);
    if ('bytes' in input) return this.madeOfFile(input);
    return 'rates' in input ? this.madeOfRates(input) : this.madeOfKeys(input);
  }

  private madeOfKeys(keys: KeyInput): Address {
    return this.withTrack(keys, (track) => this.engine.made('orispline_value_of_keys', track));
  }

  private madeOfFile(file: SceneFile): Address {
    const { engine } = this, content = contentOf(file.bytes);
    return engine.withBytes(content, (at) => engine.withText(textOf('name', file.name), (name) => withTexts(engine, textsOf(file), (list, count) =>
      engine.made('orispline_value_of_skeleton', at, content.length, name, list, count))));
  }

  private madeOfRates({ times, rates, epoch = '0' }: RateData): Address {
    const { engine } = this, seconds = numbersOf('times', times), rows = numbersOf('rates', rates);
    if (rows.length !== 3 * seconds.length) throw badArgument('rates', `found ${rows.length} numbers, wanted ${3 * seconds.length}, 3 for each of ${seconds.length} times`);
    return engine.withNumbers(seconds, (timesAt) => engine.withNumbers(rows, (ratesAt) => engine.withText(textOf('epoch', epoch), (text) =>
      engine.made('orispline_value_of_rates', timesAt, ratesAt, seconds.length, text))));
  }
}
