// SPDX-License-Identifier: Apache-2.0
// What the tests of the package have in common: the command, and the keys of the bundled flight as a script has them.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export const keysFile = join(import.meta.dirname, '../../examples/data/flight_keys.csv');

export const command = (...words) => execFileSync(process.env.ORISPLINE_COMMAND, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** The rows of a CSV as numbers. */
export const rowsOf = (text) => text.split('\n').filter((row) => /^[-\d]/.test(row)).map((row) => row.split(',').map(Number));

/** The samples of the command: t, qw, qx, qy, qz and what follows. */
export const sampled = (...options) => rowsOf(command('sample', keysFile, '--quiet', ...options));

const rows = rowsOf(readFileSync(keysFile, 'utf8'));
export const flight = {
  times: rows.map(([t]) => t),
  orientations: rows.flatMap(([, w, x, y, z]) => [w, x, y, z]),
  positions: rows.flatMap((row) => row.slice(5, 8)),
  order: 'wxyz',
};

/** Three keys, about x and about z. */
export const three = { times: [0, 1, 2.5], orientations: [0, 0, 0, 1, 0, 0, 0.6, 0.8, 0.6, 0, 0, 0.8], order: 'xyzw' };

/** The largest difference of two lists of numbers. */
export const apart = (one, other) => Math.max(...Array.from(one, (number, i) => Math.abs(number - other[i])));

/** An entry of the package. */
export const entry = (name) => import(join(process.env.ORISPLINE_NPM, `${name}.js`));

/** What a call throws. */
export const thrown = (call) => {
  try {
    call();
  } catch (error) {
    return error;
  }
  throw new Error('found no error, wanted one');
};

/** Loads an entry with its calls and its memory laid open, and `changed` put into the place of some of them. */
export const opened = async (load, changed = {}) => {
  const { Instance } = WebAssembly;
  let exports;
  WebAssembly.Instance = class {
    constructor(...about) {
      exports = { ...new Instance(...about).exports, ...changed };
      this.exports = exports;
    }
  };
  try {
    return { library: await load(), exports };
  } finally {
    WebAssembly.Instance = Instance;
  }
};
