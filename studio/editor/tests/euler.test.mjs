// SPDX-License-Identifier: Apache-2.0
// Euler angles beside products of rotation matrices, which share no formula with them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moduleOf } from './modules.mjs';

const { bodyOrders, worldOrders, fromEuler, toEuler } = await moduleOf('panels/euler.ts');

const times = (a, b) => a.map((row) => b[0].map((_, j) => row.reduce((sum, value, k) => sum + value * b[k][j], 0)));

function turned(letter, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { x: [[1, 0, 0], [0, c, -s], [0, s, c]], y: [[c, 0, s], [0, 1, 0], [-s, 0, c]], z: [[c, -s, 0], [s, c, 0], [0, 0, 1]] }[letter.toLowerCase()];
}

function matrixOfAngles(order, angles) {
  const each = [...order].map((letter, i) => turned(letter, angles[i]));
  return (order === order.toUpperCase() ? each : each.reverse()).reduce(times);
}

const matrixOf = ([w, x, y, z]) => [
  [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
  [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
  [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
];

const apart = (a, b) => Math.max(...a.flatMap((row, i) => row.map((value, j) => Math.abs(value - b[i][j]))));

let seed = 43;
const random = () => ((seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648) * 2 - 1;

test('there are twelve orders about the body’s axes and twelve about the world’s', () => {
  const orders = [...bodyOrders, ...worldOrders];
  assert.equal(new Set(orders).size, 24);
  for (const order of orders) assert.ok(order[0] !== order[1] && order[1] !== order[2], order);
});

test('angles make the rotation of three matrices, in each order', () => {
  for (const order of [...bodyOrders, ...worldOrders])
    for (let n = 0; n < 50; ++n) {
      const angles = [4 * random(), 4 * random(), 4 * random()];
      assert.ok(apart(matrixOf(fromEuler(order, angles)), matrixOfAngles(order, angles)) < 1e-14, order);
    }
});

test('angles are found again where they are in their range', () => {
  for (const order of [...bodyOrders, ...worldOrders]) {
    const isProper = order[0] === order[2];
    for (let n = 0; n < 50; ++n) {
      const angles = [3 * random(), isProper ? 1.57 + 1.5 * random() : 1.5 * random(), 3 * random()];
      toEuler(order, fromEuler(order, angles)).forEach((angle, i) => assert.ok(Math.abs(angle - angles[i]) < 1e-12, `${order} ${angles}`));
    }
  }
});

test('angles give the orientation back at gimbal lock and however near to it, and the third is 0 there', () => {
  for (const order of [...bodyOrders, ...worldOrders])
    for (const off of [0, 1e-16, 1e-12, 1e-9, 1e-7, 1e-4])
      for (const end of order[0] === order[2] ? [0, Math.PI] : [-Math.PI / 2, Math.PI / 2]) {
        const wanted = [0.7, end + (end > 0 ? -off : off), -1.1];
        const found = toEuler(order, fromEuler(order, wanted));
        assert.ok(apart(matrixOfAngles(order, found), matrixOfAngles(order, wanted)) < 1e-14, `${order} ${wanted} ${found}`);
        if (off === 0) assert.equal(Math.abs(found[2]), 0, `${order} ${found}`);
      }
});

test('both signs of a quaternion have the same angles', () => {
  const q = fromEuler('ZYX', [0.3, -0.2, 2.9]);
  toEuler('ZYX', q.map((value) => -value)).forEach((angle, i) => assert.ok(Math.abs(angle - [0.3, -0.2, 2.9][i]) < 1e-14));
});
