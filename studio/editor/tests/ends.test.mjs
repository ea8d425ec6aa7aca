// SPDX-License-Identifier: Apache-2.0
// What ends ask of each other.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moduleOf } from './modules.mjs';

const { withMethod, withSetting } = await moduleOf('edits/choice.ts');

const quintic = { name: 'quintic', parameters: [], choices: [], ends: ['repeat', 'natural', 'clamped'], closes: true };
const slerp = { name: 'slerp', parameters: [], choices: [], ends: [], closes: false };
const start = { version: 1, keys: [], first: { method: 'quintic', settings: {} }, second: { method: 'slerp', settings: {} } };
const set = (document, name, value) => withSetting(document, 'first', quintic, name, value);

test('an end that is clamped gets a rate, and loses it with another rule', () => {
  const clamped = set(start, 'ends', 'natural,clamped');
  assert.deepEqual(clamped.first.settings, { ends: 'natural,clamped', end_rate: '0,0,0' });
  const given = set(clamped, 'end_rate', '0,0,0.5');
  assert.deepEqual(given.first.settings, { ends: 'natural,clamped', end_rate: '0,0,0.5' });
  assert.deepEqual(set(given, 'ends', 'clamped').first.settings, { ends: 'clamped', end_rate: '0,0,0.5', start_rate: '0,0,0' });
  assert.deepEqual(set(given, 'ends', 'natural').first.settings, { ends: 'natural' });
  assert.deepEqual(set(given, 'ends', undefined).first.settings, {});
});

test('a rate is three numbers', () => {
  const clamped = set(start, 'ends', 'clamped');
  for (const rate of ['0,0', '0,0,x', '', 5, '0,,0']) assert.equal(set(clamped, 'start_rate', rate), clamped);
});

test('a loop has no ends, and another method keeps those that it knows', () => {
  assert.deepEqual(set(set(start, 'ends', 'clamped'), 'closed', true).first.settings, { closed: true });
  assert.deepEqual(withMethod(set(start, 'ends', 'clamped'), 'first', slerp).first.settings, {});
});
