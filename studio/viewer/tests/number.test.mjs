// SPDX-License-Identifier: Apache-2.0
// Numbers as they are shown.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleOf } from './built.mjs';

let NumberColumn, powerOfTen, stepped;
before(async () => ({ NumberColumn, powerOfTen, stepped } = await moduleOf('look/number.ts')));

const written = (values, rounding) => {
  const column = new NumberColumn(values, rounding);
  return [column.exponent, ...values.map((value) => column.text(value))];
};

test('a column has one exponent, and its decimal points stand below each other', () => {
  assert.deepEqual(written([8.21e-5, 0.001163]), [-3, '0.08210', '1.16300']);
  assert.deepEqual(written([1.5, 20.25, -3]), [0, '1.500', '20.250', '−3.000']);
  assert.deepEqual(written([15.8e6, 675.4e6]), [6, '15.80', '675.40']);
  assert.deepEqual(written([12345, 7]), [0, '12345.000', '7.000']);
});

test('what is missing, only rounding, or smaller than the digits of a column is told apart', () => {
  assert.deepEqual(written([null, NaN, 1e-33, 0.5], 1e-12), [0, '–', '–', '0', '0.5000']);
  assert.deepEqual(written([1e-9, 90000]), [3, '<0.00001', '90.00000']);
  assert.deepEqual(written([]), [0]);
});

test('powers of ten are read as such', () => assert.deepEqual([0, -3, 12].map(powerOfTen), ['', '10⁻³', '10¹²']));

test('a number of steps has no more digits than the step, wherever it is shown', () => {
  assert.equal(stepped(1.00105, 0.002), stepped(1.002, 0.002));
  assert.deepEqual([stepped(1.00105, 0.002), stepped(0.25, 0.05), stepped(31, 5), stepped(-2, 0.1), stepped(1e-6, 0.001, 1e-5)], ['1.00', '0.3', '30', '−2.0', '0']);
});
