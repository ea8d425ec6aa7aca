// SPDX-License-Identifier: Apache-2.0
// Changed baked files, always the same ones: the player refuses each in one sentence, or plays finite numbers. ORISPLINE_MUTATIONS: how many of either
// format.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

const { player } = await import(join(process.env.ORISPLINE_NPM, 'player.js'));
const count = Number(process.env.ORISPLINE_MUTATIONS ?? 1000);
const pieces = [0, 1].map(() => Array.from({ length: 24 }, (_, i) => (i === 18 ? 1 : 1e-3 * i)));
const file = { orispline: 'baked', version: 1, order: 'xyzw', epoch: 5, largest_difference: 1e-6, ends: [0, 1, 2.5], pieces };

/** Whole numbers below n, always the same (a linear congruence modulo 2³²). */
const numbers = (seed) => (n) => Math.floor(((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32) * n);

const hostile = [
  null, true, false, '', 'baked', 'xyzw', [], {}, [[]], [null], 0, -0, 1, -1, 24, 2 ** 31, 2 ** 32, 1e9, 5e-324, 1e-300, 1e38, 3.5e38, 1e300, 1.7e308, -1.7e308,
  { length: 1e9 }, { byteLength: 0, length: 1e9 }, { length: 24 },
];
const members = ['byteLength', 'byteOffset', 'buffer', 'length', 'version', 'order', 'epoch', 'ends', 'pieces', '__proto__', 'constructor', 'flat', 'every', 'toString'];

/** A document with a member or an element that is another, is gone, is there twice or is new, somewhere. */
const changed = (document, next) => {
  let place = document;
  for (;;) {
    const names = Object.keys(place), name = names[next(names.length)], inner = place[name];
    if (inner && typeof inner === 'object' && Object.keys(inner).length && next(4)) place = inner;
    else {
      const value = hostile[next(hostile.length)], how = next(5);
      if (how === 0 && Array.isArray(place)) place.splice(Number(name), 1);
      else if (how === 0) delete place[name];
      else if (how === 1 && Array.isArray(place)) place.push(inner);
      else if (how === 2 && !Array.isArray(place)) place[members[next(members.length)]] = value;
      else place[name] = value;
      return document;
    }
  }
};

const bytesOf = ({ epoch, largest_difference, ends, pieces }) => {
  const bytes = new Uint8Array(32 + 8 * ends.length + 96 * pieces.length), view = new DataView(bytes.buffer);
  bytes.set(new TextEncoder().encode('ORIBAKED'));
  view.setUint32(8, 1, true);
  view.setUint32(12, pieces.length, true);
  [epoch, largest_difference, ...ends].forEach((number, i) => view.setFloat64(16 + 8 * i, number, true));
  pieces.flat().forEach((number, i) => view.setFloat32(32 + 8 * ends.length + 4 * i, number, true));
  return bytes;
};

const changedBytes = (bytes, next) => {
  const how = next(4), at = next(bytes.length);
  if (how === 0) return bytes.subarray(0, at);
  if (how === 1) return Uint8Array.of(...bytes, ...bytes.subarray(at));
  if (how === 2) bytes.fill(next(2) * 255, at, at + 1 + next(8));
  else bytes[at] = next(256);
  return bytes;
};

/** Whether it was played. */
const isPlayed = (given, told) => {
  let motion;
  try {
    motion = player(given);
  } catch (error) {
    assert.match(error.message, /^orispline\/player: found [^\n]{1,80}, wanted version 1 of what 'orispline bake' writes$/, `${told()}: ${error.stack}`);
    return false;
  }
  const { start, end } = motion;
  for (const time of [-1.7e308, start, start / 2 + end / 2, end, 1.7e308])
    assert.ok([start, end, ...motion.at(time)].every(Number.isFinite), `${told()}: at ${time} it is ${motion.at(time)}`);
  return true;
};

for (const [name, make] of [
  ['documents', (next) => JSON.parse(JSON.stringify(changed(structuredClone(file), next)))],
  ['bytes', (next) => changedBytes(bytesOf(file), next)],
])
  test(`${count} changed ${name} are refused in one sentence, or play finite numbers`, () => {
    let played = 0;
    for (let seed = 1; seed <= count; ++seed) {
      const next = numbers(seed * 7919);
      const given = make(next);
      played += isPlayed(given, () => `change ${seed}, ${JSON.stringify(given)}`);
    }
    assert.ok(played > count / 20 && played < count - count / 20, `${played} of ${count} were played`);
  });
