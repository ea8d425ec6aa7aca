// SPDX-License-Identifier: Apache-2.0
// What the studio's worker does while a key is dragged: the curves of A and B, beside the native library.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { answers } from '../../studio/editor/tests/engine.mjs';
import { keysOf } from './keys.mjs';
import { Native } from './native.mjs';
import { here, ratioOf } from './turns.mjs';

const keyCount = 40, count = 600, methods = ['auto', 'timed-c2'], steps = 16;

const documentOf = ({ times, orientations }) => ({
  version: 1,
  keys: Array.from(times, (t, k) => ({ id: k, row: k, t, q: [...orientations.subarray(4 * k, 4 * k + 4)], p: null, rates: [], own: {} })),
  first: { method: methods[0], settings: {} },
  second: { method: methods[1], settings: {} },
});

/** As a key in the middle is turned about z, from step to step. */
const turned = (document, step) => {
  const half = step / 1000, [c, s] = [Math.cos(half), Math.sin(half)];
  const turn = ([w, x, y, z]) => [c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w];
  return { ...document, keys: document.keys.map((key, k) => (k === keyCount / 2 ? { ...key, q: turn(key.q) } : key)) };
};

const bytesOf = ({ t, q, w, a, j, orders }) => Buffer.concat([t, q, w, a, j, Float64Array.from(orders)].map(({ buffer }) => new Uint8Array(buffer)));

/** `program`: of native.cpp. */
export const drawingRatios = async (program) => {
  const folder = mkdtempSync(join(tmpdir(), 'orispline-')), keys = keysOf(keyCount, 1), native = new Native(program, folder, keys), { curves } = answers();
  const document = documentOf(keys), dragged = Array.from({ length: steps }, (_, step) => turned(document, step + 1));
  try {
    const { first, second } = curves({ document, count });
    if (!Buffer.concat([first, second].map(bytesOf)).equals(await native.drawn(methods, count)))
      throw new Error('found curves of the studio with other bits than those of the native library, wanted the same');
    let step = 0;
    const next = () => dragged[++step % steps], posted = (told) => structuredClone(told, { transfer: [told.first, told.second].flatMap((drawn) => Object.values(drawn).map(({ buffer }) => buffer)) });
    const beside = (work) => ratioOf(here(work), (calls) => native.draw(methods, count, calls));
    return [
      { what: 'its worker for such a step, beside the native library', ratio: await beside(() => curves({ document: next(), count })), most: 3 },
      { what: '… with all copies of what is posted, on both sides', ratio: await beside(() => posted(curves(structuredClone({ document: next(), count })))) },
    ];
  } finally {
    native.end();
    rmSync(folder, { recursive: true });
  }
};
