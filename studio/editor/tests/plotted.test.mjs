// SPDX-License-Identifier: Apache-2.0
// From the file to the plots and back: the command makes of what is saved the bits that are plotted.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { answers, bytesOf, example, plain, sampled } from './engine.mjs';
import { dice, moduleOf, tension } from './modules.mjs';

const edits = ['turn', 'time', 'keys', 'position', 'parameters'].map((name) => `edits/${name}.ts`);
const { savedText, methodText, ...edit } = await moduleOf('file/save.ts', 'document/methodText.ts', ...edits);

const ask = answers();
const engine = { ask: async (name, given) => ask[name](given) };
const folder = mkdtempSync(join(tmpdir(), 'orispline-plotted-'));
after(() => rmSync(folder, { recursive: true }));

const count = 61;

/** The samples that the command makes of what is saved, beside those of the engine. */
async function compare({ original, document: opened }, document, kept = true) {
  const { text, isWhole } = await savedText(original, document, engine, opened);
  assert.equal(isWhole, !kept, text.slice(0, 500));
  const path = join(folder, original.name);
  writeFileSync(path, text);
  const { keys, first: choice } = document;
  const { t, ...bits } = plain(ask.sample({ keys, choice, count, rates: 3 }));
  const { t: saved, ...wanted } = sampled(path, methodText(choice), count);
  assert.deepEqual(bits, wanted);
  saved.forEach((time, k) => assert.ok(Math.abs(time - Number(original.epoch) - t[k]) <= 1e-15 * (Math.abs(time) + 100), `${time} is not ${t[k]}`));
}

const openedFile = (name, more = {}) => ask.open({ bytes: readFileSync(example(name)), name, ...more });
const openedText = (name, text, more = {}) => ask.open({ bytes: bytesOf(text), name, ...more });

test('of a file that is not edited', async () => {
  for (const name of ['five_keys.csv', 'camera_keys.csv', 'flight_keys.csv', 'robot_keys.csv']) {
    const file = openedFile(name);
    await compare(file, file.document);
    assert.equal((await savedText(file.original, file.document, engine, file.document)).text, readFileSync(example(name), 'utf8'));
  }
});

test('where the first key was moved or deleted, whose time is what the file counts from', async () => {
  const file = openedFile('flight_keys.csv', { method: 'timed-c2' });
  for (const t of [-0.37, 0.13, 0.5]) await compare(file, edit.movedInTime(file.document, file.document.keys[0].id, t));
  await compare(file, edit.deleted(file.document, file.document.keys[0].id));
  const { document } = edit.inserted(file.document, -0.7, { q: [1, 0, 0, 0], p: [0, 0, 0] });
  await compare(file, document);
});

/** Whether a walk led rates of keys so near together that the library refuses the curve, as of the file. */
function windsTooFar({ keys, first: choice }) {
  try {
    ask.sample({ keys, choice, count: 2, rates: 0 });
    return false;
  } catch ({ message }) {
    assert.match(message, /wind the curve/);
    return true;
  }
}

const recording = ['t_ms,qw,qx,qy,qz,wx,wy,wz,note', '1700000000000.25,1,0,0,0,0.5,0,0,"a, b"', '1700000000750,0.8,0.6,0,0,,,,c', '1700000002000,0,1,0,0,0.5,0.1,0,d', ''].join('\r\n');
const tum = ['1305031098.6659 1 0 0 0 0 0 1', '1305031099.5 2 0 0 0 0.6 0 0.8', '1305031101 3 1 0 0.6 0 0 0.8', ''].join('\n');

for (const [name, file] of [
  ['the flight', openedFile('flight_keys.csv')],
  ['five keys with tensions', openedFile('five_keys.csv', { method: 'timed-c2:tension=0.3' })],
  ['rates', openedText('rates.csv', recording, { method: 'hermite-c2' })],
  ['TUM', openedText('walk.tum', tum)],
])
  test(`random walks: ${name}`, async () => {
    for (let seed = 1; seed <= 12; seed++) {
      const random = dice(seed);
      let { document } = file;
      for (let i = 0; i < 2 * seed; i++) {
        const { id, t } = document.keys[Math.floor(random() * document.keys.length)];
        const [a, b, c] = [random() - 0.5, random() - 0.5, random() - 0.5];
        const ways = [
          () => edit.turnedInWorld(document, id, [2 * a, 2 * b, 2 * c]),
          () => edit.movedInTime(document, id, t + a),
          () => edit.inserted(document, t + 2 * a, { q: [a, b, c, 1], p: [a, b, c] }).document,
          () => edit.duplicated(document, id).document,
          () => edit.deleted(document, id),
          () => edit.placed(document, id, 1, 10 * a),
          () => (name.startsWith('five') ? edit.withOwn(document, id, 'first', tension, a) : document),
        ];
        document = ways[Math.floor(random() * ways.length)]();
      }
      if (!windsTooFar(document)) await compare(file, document);
    }
  });
