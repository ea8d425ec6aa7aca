// SPDX-License-Identifier: Apache-2.0
// The engine of the studio without a worker, the compiled library, and the command beside which both are held.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { library, placeOf } from '../../pages.js';

async function built() {
  const lib = { entry: placeOf('editor/tests/engineParts.ts'), formats: ['es'] };
  const [{ output: [{ code }] }] = await build({
    configFile: false, logLevel: 'error', resolve: { alias: [library] }, build: { write: false, minify: false, target: 'es2022', lib },
  });
  return import(`data:text/javascript,${encodeURIComponent(code)}`);
}

export const engine = await built();
export const packed = gzipSync(readFileSync(process.env.ORISPLINE_STUDIO_WASM)).toString('base64');
export const module = await engine.moduleIn(packed);

/** What answers the questions, with a library of its own. */
export const answers = () => engine.answersOf(new engine.Library(module));

export const bytesOf = (text) => new TextEncoder().encode(text);
export const example = (name) => join(process.env.ORISPLINE_EXAMPLES, name);

export const command = (...words) => execFileSync(process.env.ORISPLINE_COMMAND, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** The samples of the command by the names of the studio; positions only where there are some. */
export function sampled(file, method, count) {
  const text = command('sample', file, '--method', method, '--count', String(count), '--derivatives', '3', '--quiet');
  const [header, ...rows] = text.trim().split('\n').map((row) => row.split(','));
  const columns = (...names) => (header.includes(names[0]) ? rows.flatMap((row) => names.map((name) => Number(row[header.indexOf(name)]))) : []);
  const vector = (letter) => columns(...['x', 'y', 'z'].map((axis) => letter + axis));
  return { t: columns('t'), q: columns('qw', 'qx', 'qy', 'qz'), w: vector('w'), a: vector('a'), j: vector('j'), p: vector('p') };
}

export const plain = (samples) => Object.fromEntries(Object.entries(samples).map(([name, numbers]) => [name, [...numbers]]));
