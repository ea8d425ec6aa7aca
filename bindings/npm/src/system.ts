// SPDX-License-Identifier: Apache-2.0
// What the compiled code may ask of a system, by the interface of WASI: there are no files, no variables, and what it prints before it ends
// is why it ends.

type Call = (...values: number[]) => number;

const done = 0, noSuchFile = 8;

export class System {
  memory!: WebAssembly.Memory;
  /** What was printed. */
  said = '';

  /** For the imports of a module; what is not here has no such file. */
  importsOf(module: WebAssembly.Module): Record<string, Record<string, Call>> {
    const calls: Record<string, Call> = { environ_sizes_get: (...places) => this.nothingAt(places), environ_get: () => done, fd_write: this.written, proc_exit: this.ended };
    const imports: Record<string, Record<string, Call>> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = calls[name] ?? (() => noSuchFile);
    return imports;
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

  private readonly ended: Call = (status) => {
    throw new Error(`it ended with ${status}`);
  };
}
