// SPDX-License-Identifier: Apache-2.0
// Lists of numbers and documents, as they are read.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleOf } from './built.mjs';
import { f2, f4, f8, u4 } from './encoded.mjs';

let numbersOf, readDocument;
before(async () => {
  ({ numbersOf } = await moduleOf('data/numbers.ts'));
  ({ readDocument } = await moduleOf('data/document.ts'));
});

const bits = (values) => ({ f2: Buffer.from(Uint16Array.from(values).buffer).toString('base64'), unit: 1 });

test('a list of numbers is read in each of its forms', () => {
  const values = [0, 1, -0.5, NaN, 0.25];
  const written = values.map((value) => (Number.isNaN(value) ? null : value));
  for (const list of [written, f4(written), f8(written), f2(written)]) assert.deepEqual(Array.from(numbersOf(list)), values);
  assert.deepEqual(Array.from(numbersOf(u4([2, 2.5, 4], 2, 0.5))), [2, 2.5, 4]);
  for (const none of [[], f4([]), f8([]), f2([])]) assert.equal(numbersOf(none).length, 0);
});

test('half floats are read with their unit, and exactly where binary16 has them', () => {
  assert.deepEqual(Array.from(numbersOf({ ...f2([1, -0.5]), unit: 12.5 })), [12.5, -6.25]);
  const worked = [[0x3c00, 1], [0xc000, -2], [0x7bff, 65504], [0x0400, 2 ** -14], [0x0001, 2 ** -24], [0x03ff, 1023 * 2 ** -24], [0x3555, 0.333251953125], [0x7c00, NaN], [0x7e00, NaN]];
  assert.deepEqual(Array.from(numbersOf(bits(worked.map(([code]) => code)))), worked.map(([, value]) => value));
});

test('a list in no known form says so', () => assert.throws(() => numbersOf({ f3: '' }), /a form that is not known: \{"f3":""\}/));

const none = { q: [], w: [], a: [], j: [], torque: [], p: [], error_t: [], error_deg: [] };
const method = (name, t, more) => ({ name, continuity: 'C0', failure: '', measures: {}, samples: { ...none, t, ...more }, keys: null });

test('a document of version 1, which has arrays and no version, is read', () => {
  const { methods, keys, title } = readDocument({ title: 'T', keys: { t: [0], q: [1, 0, 0, 0], p: [] }, methods: [method('a', [0, 1], { q: [1, 0, 0, 0, null, null, null, null] })] });
  assert.equal(title, 'T');
  assert.deepEqual(Array.from(methods[0].samples.q), [1, 0, 0, 0, NaN, NaN, NaN, NaN]);
  assert.equal(methods[0].keys, keys);
  assert.deepEqual([methods[0].clock, methods[0].bands, methods[0].samples.exactness_deg], [null, {}, null]);
});

test('equal times are one list', () => {
  const { methods } = readDocument({ data: 2, methods: [method('a', u4([0, 1], 0, 0.5)), method('b', { like: 0 }), method('c', [0, 1]), method('d', [0, 2])] });
  const [a, b, c, d] = methods.map(({ samples }) => samples.t);
  assert.equal(b, a);
  assert.equal(c, a);
  assert.notEqual(d, a);
  const errors = [method('a', [0, 1], { error_t: [2, 3] }), method('b', [0, 2], { error_t: { like: 0 }, error_deg: [1, 4] })];
  assert.deepEqual(Array.from(readDocument({ methods: errors }).methods[1].samples.error_t), [2, 3]);
  assert.throws(() => readDocument({ methods: [method('a', { like: 1 }), method('b', [0])] }), /those of a later method/);
});

test('a document of a later version says so', () => assert.throws(() => readDocument({ data: 3 }), /found data of version 3, wanted version 2 or an older one/));
