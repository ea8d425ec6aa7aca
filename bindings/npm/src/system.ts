// SPDX-License-Identifier: Apache-2.0
// What the compiled code may ask of a system, by the interface of WASI: there are no files, no variables, and what it prints before it ends
// is why it ends.

import { badArgument, shown } from './errors.js';

type Call = (...values: number[]) => number;

/** Is told the share of a task that is done, from 0 to 1. Where it returns true, the task ends. */
export type Progress = (share: number) => boolean | void;

const done = 0, noSuchFile = 8;

export class System {
  memory!: WebAssembly.Memory;
  /** What was printed. */
  said = '';
  /** What is told of a task; any other number than 0 ends it. */
  private shown: Call = () => 0;

  /** For the imports of a module; what is not here has no such file. */
  importsOf(module: WebAssembly.Module): Record<string, Record<string, Call>> {
    const calls: Record<string, Call> = { environ_sizes_get: (...places) => this.nothingAt(places), environ_get: () => done, fd_write: this.written, clock_time_get: this.timed, proc_exit: this.ended, progress: (share) => this.shown(share) };
    const imports: Record<string, Record<string, Call>> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = calls[name] ?? (() => noSuchFile);
    return imports;
  }

  /** Does some work that is told of. What `progress` throws ends it too and comes out here, not through compiled code, whose stack would be lost. */
  showing<Result>(progress: Progress | null | undefined, work: () => Result): Result {
    if (typeof (progress ?? Number) !== 'function') throw badArgument('progress', `found ${shown(progress)}, wanted a function`);
    const before = this.shown;
    let thrown: { reason: unknown } | undefined;
    this.shown = (share) => {
      try {
        return Number(progress?.(share) === true);
      } catch (reason) {
        thrown ??= { reason };
        return 1;
      }
    };
    try {
      const found = work();
      if (!thrown) return found;
    } catch (error) {
      if (!thrown) throw error;
    } finally {
      this.shown = before;
    }
    throw thrown.reason;
  }

  private nothingAt(places: number[]): number {
    for (const place of places) new Uint32Array(this.memory.buffer, place, 1)[0] = 0;
    return done;
  }

  private readonly written: Call = (_, pieces, count, total) => {
    const words = new Uint32Array(this.memory.buffer, pieces, 2 * count);
    let length = 0;
    for (let k = 0; k < words.length; k += 2) {
      this.said += new TextDecoder().decode(new Uint8Array(this.memory.buffer, words[k], words[k + 1]).slice());
      length += words[k + 1];
    }
    new Uint32Array(this.memory.buffer, total, 1)[0] = length;
    return done;
  };

  /** [ns], in 64 bits, of a clock that never goes back: `compare` says how long its methods take. */
  private readonly timed: Call = (_clock, _precision, place) => {
    new BigUint64Array(this.memory.buffer, place, 1)[0] = BigInt(Math.round(1e6 * performance.now()));
    return done;
  };

  private readonly ended: Call = (status) => {
    throw new Error(`it ended with ${status}`);
  };
}
