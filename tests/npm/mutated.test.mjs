// SPDX-License-Identifier: Apache-2.0
// Changed baked files, always the same ones: the player refuses each in one sentence, or plays finite numbers. ORISPLINE_MUTATIONS: how many of either
// format.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

const { player } = await import(join(process.env.ORISPLINE_NPM, 'player.js'));
const count = Number(process.env.ORISPLINE_MUTATIONS ?? 1000);
const pieces = [0, 1].map(() => Array.from({ length: 24 }, (_, i) => (i === 18 ? 1 : 1e-3 * i)));
const plain = { orispline: 'baked', version: 1, order: 'xyzw', epoch: 5, largest_difference: 1e-6, ends: [0, 1, 2.5], pieces };
const withPositions = { ...plain, version: 2, largest_position_difference: 1e-4, position_ends: [0, 2.5], position_pieces: [Array.from({ length: 18 }, (_, i) => 0.1 * i)] };

/** Whole numbers below n, always the same (a linear congruence modulo 2³²). */
const numbers = (seed) => (n) => Math.floor(((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32) * n);

const hostile = [
  null, true, false, '', 'baked', 'xyzw', [], {}, [[]], [null], 0, -0, 1, -1, 24, 2 ** 31, 2 ** 32, 1e9, 5e-324, 1e-300, 1e38, 3.5e38, 1e300, 1.7e308, -1.7e308,
  { length: 1e9 }, { byteLength: 0, length: 1e9 }, { length: 24 },
];
const members = ['byteLength', 'byteOffset', 'buffer', 'length', 'version', 'order', 'epoch', 'ends', 'pieces', 'position_ends', 'position_pieces', '__proto__', 'constructor', 'flat', 'every', 'toString'];

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

const bytesOf = ({ version, epoch, largest_difference, ends, pieces, largest_position_difference, position_ends, position_pieces }) => {
  const bytes = new Uint8Array(32 + 8 * ends.length + 96 * pieces.length + (position_ends ? 16 + 8 * position_ends.length + 84 * position_pieces.length : 0));
  const view = new DataView(bytes.buffer);
  let at = 8;
  const put = (size, write, numbers) => numbers.forEach((number) => (view[write](at, number, true), (at += size)));
  bytes.set(new TextEncoder().encode('ORIBAKED'));
  put(4, 'setUint32', [version, pieces.length]);
  put(8, 'setFloat64', [epoch, largest_difference, ...ends]);
  put(4, 'setFloat32', pieces.flat());
  if (!position_ends) return bytes;
  const coefficients = position_pieces.flat();
  put(4, 'setUint32', [position_pieces.length, 0]);
  put(8, 'setFloat64', [largest_position_difference, ...position_ends, ...coefficients.filter((_, k) => k % 6 === 0)]);
  put(4, 'setFloat32', coefficients.filter((_, k) => k % 6));
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
    assert.match(error.message, /^orispline\/player: found [^\n]{1,80}, wanted version 1 or 2 of what 'orispline bake' writes$/, `${told()}: ${error.stack}`);
    return false;
  }
  const { start, end } = motion;
  for (const time of [-1.7e308, start, start / 2 + end / 2, end, 1.7e308])
    for (const there of [motion.at(time), ...(motion.hasPositions ? [motion.positionAt(time)] : [])])
      assert.ok([start, end, ...there].every(Number.isFinite), `${told()}: at ${time} it is ${there}`);
  return true;
};

for (const [name, make] of [
  ['documents', (next, file) => JSON.parse(JSON.stringify(changed(structuredClone(file), next)))],
  ['bytes', (next, file) => changedBytes(bytesOf(file), next)],
])
  test(`${count} changed ${name} are refused in one sentence, or play finite numbers`, () => {
    let played = 0;
    for (let seed = 1; seed <= count; ++seed) {
      const next = numbers(seed * 7919), file = seed % 2 ? plain : withPositions;
      const given = make(next, file);
      played += isPlayed(given, () => `change ${seed}, ${JSON.stringify(given)}`);
    }
    assert.ok(played > count / 20 && played < count - count / 20, `${played} of ${count} were played`);
  });
