// SPDX-License-Identifier: Apache-2.0
// Samples in bulk and the making of curves, by `orispline` beside the native library.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { keysOf } from './keys.mjs';
import { Native } from './native.mjs';
import { here, ratioOf } from './turns.mjs';

const keyCount = 1000, count = 100_000, methods = ['auto', 'timed-c2'];

const bytesOf = ({ times, orientations, angularVelocities, angularAccelerations }) =>
  Buffer.concat([times, orientations, angularVelocities, angularAccelerations].filter(Boolean).map(({ buffer }) => new Uint8Array(buffer)));

const samplingRatio = async (ori, native, keys, method, rates) => {
  const curve = ori.curve(method, keys), { start, end } = curve, options = { start, step: (end - start) / count, count, rates };
  if (!bytesOf(curve.sample(options)).equals(await native.samples(method, rates, count)))
    throw new Error(`${method}: found samples with other bits than those of the native library, wanted the same`);
  return ratioOf(here(() => curve.sample(options)), (calls) => native.sample(method, rates, count, calls));
};

const makingRatio = (ori, native, keys, method) =>
  ratioOf(here(() => ori.curve(method, keys).dispose()), (calls) => native.make(method, calls));

/** `load`: of `orispline`; `program`: of native.cpp. */
export const curveRatios = async (load, program) => {
  const folder = mkdtempSync(join(tmpdir(), 'orispline-')), keys = keysOf(keyCount, 1), native = new Native(program, folder, keys), ori = await load(), found = [];
  try {
    for (const [rates, what] of [[0, 'q'], [2, 'q, ω and α']])
      for (const method of methods)
        found.push({ what: `${count} samples, ${what}, of \`${method}\``, ratio: await samplingRatio(ori, native, keys, method, rates), most: 2 });
    for (const method of methods) found.push({ what: `making \`${method}\` of ${keyCount} keys`, ratio: await makingRatio(ori, native, keys, method), most: 3 });
    return found;
  } finally {
    native.end();
    rmSync(folder, { recursive: true });
  }
};
