// SPDX-License-Identifier: Apache-2.0
// The native library in a process of its own, which waits while the package has its turn.
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

export class Native {
  /** `program`: that of native.cpp; `folder`: for its files; `keys`: in the order wxyz. */
  constructor(program, folder, { times, orientations }) {
    const file = join(folder, 'keys.bin');
    writeFileSync(file, new Uint8Array(Float64Array.of(...times, ...orientations).buffer));
    this.folder = folder;
    // Elsewhere there is one instruction set only.
    const env = process.arch === 'x64' ? { ...process.env, ORISPLINE_ISA: 'v2' } : process.env;
    this.child = spawn(program, [file], { env, stdio: ['pipe', 'pipe', 'inherit'] });
    this.lines = createInterface({ input: this.child.stdout })[Symbol.asyncIterator]();
  }

  async told(order) {
    this.child.stdin.write(`${order}\n`);
    const { value, done } = await this.lines.next();
    if (done) throw new Error(`found no answer of the native program to '${order}', wanted one line`);
    return value;
  }

  /** Processor time [s]. */
  async make(method, calls) {
    return Number(await this.told(`make ${method} ${calls}`));
  }

  async sample(method, rates, count, calls) {
    return Number(await this.told(`sample ${method} ${rates} ${count} ${calls}`));
  }

  /** Without times, and into memory that was touched before. */
  async fill(method, rates, count, calls) {
    return Number(await this.told(`fill ${method} ${rates} ${count} ${calls}`));
  }

  /** Times, orientations, angular velocities and angular accelerations, as far as they are asked for. */
  async samples(method, rates, count) {
    const file = join(this.folder, 'samples.bin');
    await this.told(`write ${method} ${rates} ${count} ${file}`);
    return readFileSync(file);
  }

  /** Of a curve of each method as the studio draws it. */
  async draw(methods, count, calls) {
    return Number(await this.told(`draw ${count} ${calls} ${methods.join(' ')}`));
  }

  /** Times, orientations, rates and orders of these curves. */
  async drawn(methods, count) {
    const file = join(this.folder, 'drawn.bin');
    await this.told(`drawn ${count} ${file} ${methods.join(' ')}`);
    return readFileSync(file);
  }

  end() {
    this.child.stdin.end();
  }
}
