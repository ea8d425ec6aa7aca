// SPDX-License-Identifier: Apache-2.0
// Lines in space with fewer points.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleOf } from './built.mjs';

let thinned;
before(async () => ({ thinned } = await moduleOf('scene/thinned.ts')));

const circle = (count) => Float32Array.from({ length: 3 * count }, (_, i) => [Math.cos, Math.sin, () => 0][i % 3]((2 * Math.PI * Math.floor(i / 3)) / (count - 1)));
const pointsOf = (list) => Array.from({ length: list.length / 3 }, (_, i) => Array.from(list.subarray(3 * i, 3 * i + 3)));

test('a circle keeps so many points that its chords are near to it, and both ends', () => {
  const tolerance = 1e-3;
  const left = pointsOf(thinned(circle(1001), tolerance));
  assert.ok(left.length < 100, `${left.length}`);
  assert.deepEqual([left[0], left.at(-1)], [pointsOf(circle(1001))[0], pointsOf(circle(1001)).at(-1)]);
  for (let i = 0; i + 1 < left.length; ++i) {
    const middle = left[i].map((value, k) => (value + left[i + 1][k]) / 2);
    assert.ok(1 - Math.hypot(...middle) < tolerance + 1e-6);
  }
});

test('corners and gaps stay where they are', () => {
  const corner = Float32Array.of(0, 0, 0, 0.5, 0, 0, 1, 0, 0, 1, 1, 0);
  assert.deepEqual(pointsOf(thinned(corner, 1e-3)), [[0, 0, 0], [1, 0, 0], [1, 1, 0]]);
  const gap = Float32Array.of(0, 0, 0, 1, 0, 0, NaN, NaN, NaN, 2, 0, 0, 3, 0, 0);
  assert.deepEqual(pointsOf(thinned(gap, 1e-3)), [[0, 0, 0], [1, 0, 0], [NaN, NaN, NaN], [2, 0, 0], [3, 0, 0]]);
});

test('of nothing nothing is left', () => assert.equal(thinned(new Float32Array(), 1).length, 0));
