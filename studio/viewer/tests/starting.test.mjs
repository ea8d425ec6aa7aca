// SPDX-License-Identifier: Apache-2.0
// What is shown at first.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleOf } from './built.mjs';

let startingTime;
before(async () => ({ startingTime } = await moduleOf('motion/startingTime.ts')));

const none = new Float64Array();
const list = (...values) => Float64Array.from(values);
const samples = { t: list(0, 1, 2), q: list(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0), w: none, error_t: none, error_deg: none };
const method = (changes = {}, clock = null) => ({ samples: { ...samples, ...changes }, clock });
const turnedAt1 = method({ q: list(1, 0, 0, 0, 0.8, 0.6, 0, 0, 1, 0, 0, 0) });

test('the start is where the error of the first method is the largest', () => {
  assert.equal(startingTime(method({ error_deg: list(0, NaN, 3) }), turnedAt1, 0), 2);
  assert.equal(startingTime(method({ error_t: list(0.5, 0.6), error_deg: list(2, 1) }), turnedAt1, 0), 0.5);
});

test('without errors it is where both methods differ most', () => {
  assert.equal(startingTime(method(), turnedAt1, 0), 1);
  assert.equal(startingTime(method({ error_deg: list(0, 1e-6, 0) }), turnedAt1, 0), 1);
});

test('else it is where the first one turns fastest: where both are the same, or one is alone, or has a clock of its own', () => {
  const turning = method({ w: list(0, 0, 1, 0, 3, 0, 2, 0, 0) });
  const clock = { t: list(0, 2), own: list(0, 1) };
  assert.equal(startingTime(turning, undefined, 0), 1);
  assert.equal(startingTime(turning, turning, 0), 1);
  assert.equal(startingTime(turning, method({ q: turnedAt1.samples.q }, clock), 0), 1);
});

test('else it is the start: where nothing turns, or the first one has a clock of its own', () => {
  assert.equal(startingTime(method(), method(), 0), 0);
  assert.equal(startingTime(turnedAt1, undefined, 0.25), 0.25);
  assert.equal(startingTime(undefined, undefined, 0), 0);
  const clock = { t: list(0, 2), own: list(0, 1) };
  assert.equal(startingTime(method({}, clock), turnedAt1, 0), 0);
  assert.equal(startingTime(turnedAt1, method({}, clock), 0), 0);
});
