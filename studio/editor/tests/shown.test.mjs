// SPDX-License-Identifier: Apache-2.0
// What the viewer is shown of the curves, and the forms of orientations.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { documentOf, keysOfAngles, moduleOf } from './modules.mjs';

const { Shown, formNamed, groups, reachedText, jumps } = await moduleOf('store/shown.ts', 'panels/forms.ts', 'store/reached.ts');

const document = documentOf(keysOfAngles([0, 1, 2]), { method: 'timed-c2', settings: { tension: 0.6 } });
const samples = { t: Float64Array.of(0, 2), q: new Float64Array(8), w: new Float64Array(6), a: new Float64Array(6), j: new Float64Array(6), p: new Float64Array(), orders: Int8Array.of(3, 2, 3) };
const trouble = { message: 'No.' };

test('methods are named by what they are for and their settings', () => {
  const report = new Shown().report(document, { first: samples, second: samples });
  assert.deepEqual(report.methods.map(({ name }) => name), ['Curve timed-c2:tension=0.6', 'beside slerp']);
  assert.deepEqual([report.first, report.second], ['Curve timed-c2:tension=0.6', 'beside slerp']);
});

test('a choice that is refused keeps its last curve, and says why', () => {
  const shown = new Shown();
  assert.deepEqual(shown.report(document, { first: { trouble }, second: samples }).methods.map(({ name }) => name), ['beside slerp']);
  shown.report(document, { first: samples, second: samples });
  const [first] = shown.report({ ...document, first: { method: 'bezier', settings: {} } }, { first: { trouble }, second: samples }).methods;
  assert.deepEqual([first.name, first.failure, first.samples.t], ['Curve timed-c2:tension=0.6', 'No.', samples.t]);
});

test('each form leads back to the orientation', () => {
  const q = [0.5, 0.1, -0.7, 0.5].map((value) => value / Math.hypot(0.5, 0.1, 0.7, 0.5));
  for (const [, forms] of groups)
    for (const form of forms) {
      const back = form.orientationOf(form.numbersOf(q));
      const dot = back.reduce((sum, value, i) => sum + value * q[i], 0) / Math.hypot(...back);
      assert.ok(Math.abs(Math.abs(dot) - 1) < 1e-14, form.id);
    }
  assert.match(formNamed('quaternion').orientationOf([0, 0, 0, 0]), /not all 0/);
});

test('what is reached is said in words', () => {
  assert.deepEqual([-1, 0, 1, 2, 3].map(reachedText), ['orientation jumps', 'velocity jumps', 'acceleration jumps', 'smooth, jerk jumps', 'smooth']);
  assert.deepEqual([-1, 0, 1, 2, 3].map(jumps), [true, true, true, false, false]);
});
