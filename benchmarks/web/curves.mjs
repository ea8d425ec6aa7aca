// SPDX-License-Identifier: Apache-2.0
// Samples in bulk and the making of curves, by `orispline` beside the native library.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { keysOf } from './keys.mjs';
import { Native } from './native.mjs';
import { here, ratioOf } from './turns.mjs';

const keyCount = 1000, count = 1_000_000, methods = ['auto', 'timed-c2'];

const bytesOf = ({ times, orientations, angularVelocities, angularAccelerations }) =>
  Buffer.concat([times, orientations, angularVelocities, angularAccelerations].filter(Boolean).map(({ buffer }) => new Uint8Array(buffer)));

/** The call of the compiled code that `sample` makes, without new memory, copies and times. */
const codeAlone = (curve, { start, step, count, rates }) => {
  const { engine, handle, orderNumber } = curve, numbers = engine.memoryFor(8 * (4 + 3 * rates) * count), outputs = engine.memoryFor(16 * (rates + 1));
  for (let k = 0; k <= rates; ++k) engine.words(outputs + 16 * k, 4).set([k, 0, numbers + (k && 8 * (1 + 3 * k) * count), 0]);
  return {
    run: () => engine.check('orispline_sample_even', handle, start, step, count, orderNumber, 0, 1, outputs, rates + 1),
    free: () => [numbers, outputs].forEach((at) => engine.free('free', at)),
  };
};

const samplingRatios = async (ori, native, keys, method, rates) => {
  const curve = ori.curve(method, keys), { start, end } = curve, options = { start, step: (end - start) / count, count, rates };
  if (!bytesOf(curve.sample(options)).equals(await native.samples(method, rates, count)))
    throw new Error(`${method}: found samples with other bits than those of the native library, wanted the same`);
  const alone = codeAlone(curve, options), found = {
    whole: await ratioOf(here(() => curve.sample(options)), (calls) => native.sample(method, rates, count, calls)),
    alone: await ratioOf(here(alone.run), (calls) => native.fill(method, rates, count, calls)),
  };
  alone.free();
  curve.dispose();
  return found;
};

const makingRatio = (ori, native, keys, method) =>
  ratioOf(here(() => ori.curve(method, keys).dispose()), (calls) => native.make(method, calls));

/** `load`: of `orispline`; `program`: of native.cpp. */
export const curveRatios = async (load, program) => {
  const folder = mkdtempSync(join(tmpdir(), 'orispline-')), keys = keysOf(keyCount, 1), native = new Native(program, folder, keys), ori = await load(), found = [];
  try {
    for (const [rates, what] of [[0, 'q'], [2, 'q, ω and α']])
      for (const method of methods) {
        const { whole, alone } = await samplingRatios(ori, native, keys, method, rates);
        found.push({ what: `\`sample\`, ${count} times ${what}, \`${method}\``, ratio: whole, most: 2 }, { what: '… the compiled code alone', ratio: alone, most: 2 });
      }
    for (const method of methods) found.push({ what: `making \`${method}\`, ${keyCount} keys`, ratio: await makingRatio(ori, native, keys, method), most: 3 });
    return found;
  } finally {
    native.end();
    rmSync(folder, { recursive: true });
  }
};
