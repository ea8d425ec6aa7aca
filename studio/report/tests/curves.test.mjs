// SPDX-License-Identifier: Apache-2.0
// What a page plots, beside what the command samples: ORISPLINE_COMMAND names the command, ORISPLINE_EXAMPLES the folder of example
// data, ORISPLINE_SHARED_DATA one of recordings that a test may do without.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { moduleOf } from '../../viewer/tests/built.mjs';
import { documentOf } from './document.mjs';

const { ORISPLINE_COMMAND: command, ORISPLINE_EXAMPLES: examples = '', ORISPLINE_SHARED_DATA: shared = '' } = process.env;
const chord = 0.005; // [deg] of the page's lines; at least as much is stated of its samples
const rounding = 1e-4; // [deg] of 32 bit quaternions
const folder = mkdtempSync(join(tmpdir(), 'orispline-curves-'));
let lines, readDocument;
before(async () => {
  lines = await moduleOf('motion/lines.ts');
  ({ readDocument } = await moduleOf('data/document.ts'));
});
after(() => rmSync(folder, { recursive: true }));

const run = (...words) => execFileSync(command, words, { stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 2 ** 28 });
const isRow = (line) => /^[-+\d.]/.test(line);

/** Every so manyth row of a table, below its head; of the first ones. */
function thinned(text, every, most) {
  const all = text.split('\n');
  const rows = all.filter(isRow).slice(0, most);
  return [all.filter((line) => line !== '' && !isRow(line)), rows, rows.filter((_, i) => i % every === 0)];
}

/** Times and quaternions of a file of NumPy. */
function samplesOf(file) {
  const bytes = readFileSync(file);
  const size = bytes.readUInt16LE(8);
  const [, count, width] = /\((\d+), (\d+)\)/.exec(bytes.toString('latin1', 10, 10 + size)).map(Number);
  const values = new Float64Array(bytes.buffer.slice(bytes.byteOffset + 10 + size));
  return Array.from({ length: count }, (_, i) => [values[i * width], values.subarray(i * width + 1, i * width + 5)]);
}

const angle = (p, q) => {
  const [a, b, c, d] = p;
  const [w, x, y, z] = q;
  const turn = [a * w + b * x + c * y + d * z, a * x - b * w - c * z + d * y, a * y - c * w - d * x + b * z, a * z - d * w - b * y + c * x];
  return (2 * Math.atan2(Math.hypot(turn[1], turn[2], turn[3]), Math.abs(turn[0])) * 180) / Math.PI;
};

/** How far values are from a polyline at most; at a jump from the nearer side, and not in a gap. */
function farthest({ t, values }, wanted) {
  let [most, i] = [0, 0];
  const room = 1e-8 * (t.at(-1) - t[0]);
  for (const [time, value] of wanted) {
    while (i + 2 < t.length && t[i + 1] <= time - room) ++i;
    let off = Infinity;
    for (let k = i; k + 1 < t.length && t[k] <= time + room; ++k) {
      const u = t[k + 1] > t[k] ? Math.min(Math.max((time - t[k]) / (t[k + 1] - t[k]), 0), 1) : 0;
      const plotted = u === 0 ? values[k] : u === 1 ? values[k + 1] : (1 - u) * values[k] + u * values[k + 1];
      if (Number.isNaN(plotted)) off = 0;
      off = Math.min(off, Math.abs(plotted - value));
    }
    if (off < Infinity) most = Math.max(most, off);
  }
  return most;
}

const halfFloat = 2 ** -11; // how far one is from what it stands for, relative to it

const stated = ({ samples }) => Math.max(chord, samples.exactness_deg) + chord + rounding;

/** The errors that are drawn have the largest one of the table, at its time. */
function expectLargestError(name, { error_t, error_deg }, { max_deg, max_at_s }) {
  const drawn = error_deg.reduce((largest, value) => (value > largest ? value : largest), 0);
  assert.ok(Math.abs(drawn - max_deg) <= halfFloat * max_deg + 1e-6, `${name}: ${drawn} is drawn, ${max_deg} is in the table`);
  const there = error_deg[error_t.findIndex((t) => Math.abs(t - max_at_s) < 1e-6 * Math.max(1, Math.abs(t)))];
  assert.equal(there, drawn, `${name}: ${there} at ${max_at_s} s`);
}

const recordings = {
  'of a flight': [join(examples, 'flight_truth.csv'), 8],
  'of a robot': [join(examples, 'robot_keys.csv'), 2],
  'of a camera': [join(examples, 'camera_keys.csv'), 2],
  'of a hand that carries a camera': [join(shared, 'trajectory/tum_fr2_desk_groundtruth.txt'), 8, 2400],
};
for (const [name, [file, every, most]] of Object.entries(recordings)) {
  const skip = !command ? 'ORISPLINE_COMMAND names no command' : !existsSync(file) && `${file} is not here`;
  test(`every line of angles on the page ${name} is within its stated angle of the curve`, { skip }, () => {
    const [head, rows, keys] = thinned(readFileSync(file, 'utf8'), every, most);
    const extension = file.slice(file.lastIndexOf('.'));
    const [all, kept, page, samples] = ['all', 'kept', 'page', 'samples'].map((part, i) => join(folder, part + [extension, extension, '.html', '.npy'][i]));
    writeFileSync(all, [...head, ...rows, ''].join('\n'));
    writeFileSync(kept, [...head, ...keys, ''].join('\n'));
    run('compare', all, '--keep-every', String(every), '--drop-duplicates', '--report', page);
    const { methods } = readDocument(documentOf(page));
    const working = methods.filter(({ failure }) => !failure);
    assert.ok(working.length > 10);
    for (const { name, samples, measures } of working) expectLargestError(name, samples, measures);
    let beside;
    for (const method of working) {
      run('sample', kept, '--drop-duplicates', '--method', method.name, '--rate', '1000', '--derivatives', '0', '-o', samples);
      const sampled = samplesOf(samples).map(([t, q], _, [[first]]) => [method.samples.t[0] + t - first, q]);
      const [, start] = sampled[0];
      const off = farthest(lines.anglesFromStart(method.samples), sampled.map(([t, q]) => [t, angle(start, q)]));
      assert.ok(off <= stated(method), `${method.name}: ${off}, stated ${stated(method)}`);
      if (beside) {
        const other = new Map(beside.sampled.map(([t, q]) => [t.toFixed(6), q]));
        const apart = sampled.flatMap(([t, q]) => (other.has(t.toFixed(6)) ? [[t, angle(other.get(t.toFixed(6)), q)]] : []));
        const both = farthest(lines.anglesApart(beside.method.samples, method.samples), apart);
        assert.ok(both <= stated(beside.method) + stated(method), `${beside.method.name}, ${method.name}: ${both}`);
      }
      beside = { method, sampled };
    }
  });
}
