// SPDX-License-Identifier: Apache-2.0
// The largest angle that a page plots, as it is told outside of it. FLIGHT_PAGE names the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moduleOf } from '../../viewer/tests/built.mjs';
import { apart } from '../../tests/apart.mjs';
import { documentOf } from './document.mjs';

const file = process.env.FLIGHT_PAGE;

test('the largest angle of a page is that of its own lines', async () => {
  const { anglesApart } = await moduleOf('motion/lines.ts');
  const { readDocument } = await moduleOf('data/document.ts');
  const { methods } = readDocument(documentOf(file));
  const [slerp, squad] = ['slerp', 'squad'].map((wanted) => methods.find(({ name }) => name === wanted).samples);
  const { t, values } = anglesApart(slerp, squad);
  const angle = values.reduce((most, value) => Math.max(most, value), 0); // NaN is not larger
  const found = apart(file, 'slerp', 'squad');
  assert.ok(Math.abs(found.angle - angle) < 1e-12, `${found.angle} ${angle}`); // browsers round sines in their own ways
  assert.equal(found.time, t[values.indexOf(angle)]);
});

test('a method that is not on the page is named', () => assert.throws(() => apart(file, 'slerp', 'gone'), /has no method gone/));
