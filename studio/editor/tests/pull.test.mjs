// SPDX-License-Identifier: Apache-2.0
// What a pull at a scene means, in numbers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Ray, Vector3 } from 'three';
import { moduleOf } from '../../viewer/tests/built.mjs';

const { directionUnder, turnBetween, turnOfRing } = await moduleOf('../../editor/src/scene/pull.ts');
const near = (some, others) => some.forEach((value, i) => assert.ok(Math.abs(value - others[i]) < 1e-12, `${some}, wanted ${others}`));
const eye = new Vector3(0, -4, 0);
const rayTo = (x, y, z, from = eye) => new Ray(from.clone(), new Vector3(x, y, z).sub(from).normalize());

test('a ray meets the ball before it or behind', () => {
  near(directionUnder(rayTo(0, 0, 0), 1, false).toArray(), [0, -1, 0]);
  near(directionUnder(rayTo(0, 0, 0), 1, true).toArray(), [0, 1, 0]);
  const point = new Vector3(0.3, -0.8, 0.5).normalize();
  for (const radius of [1, 1.004]) near(directionUnder(rayTo(...point.clone().multiplyScalar(radius)), radius, false).toArray(), point.toArray());
  const far = new Vector3(0.1, 0.9, -0.2).normalize();
  near(directionUnder(rayTo(...far), 1, true).toArray(), far.toArray());
});

test('beyond its edge a ray is at the nearest point of the outline, on both sides alike', () => {
  for (const isBehind of [false, true]) near(directionUnder(rayTo(5, 0, 0), 1, isBehind).toArray(), [Math.sqrt(15) / 4, -1 / 4, 0]);
  near(directionUnder(rayTo(0, 3, -9), 1, false).toArray(), [0, -1 / 4, -Math.sqrt(15) / 4]);
});

test('the smallest turn has no roll, and half a turn is one too', () => {
  near(turnBetween(new Vector3(1, 0, 0), new Vector3(0, 1, 0)), [0, 0, Math.PI / 2]);
  near(turnBetween(new Vector3(0, 0, 1), new Vector3(0, 0, 1)), [0, 0, 0]);
  for (const axis of [new Vector3(1, 0, 0), new Vector3(0, 0, 1)]) {
    const turn = new Vector3(...turnBetween(axis, axis.clone().negate()));
    near([turn.length(), turn.dot(axis)], [Math.PI, 0]);
  }
  const tiny = turnBetween(new Vector3(1, 0, 0), new Vector3(1, 1e-9, 0).normalize());
  near(tiny, [0, 0, 1e-9]);
});

test('a ring that faces the eye is pulled around, one that is seen from its side along', () => {
  const facing = { middle: new Vector3(), axis: new Vector3(0, -1, 0), radius: 0.5 };
  assert.ok(Math.abs(turnOfRing(facing, rayTo(0.5, 0, 0), rayTo(0, 0, 0.5)) - Math.PI / 2) < 1e-12); // from x to z about -y
  const across = { middle: new Vector3(), axis: new Vector3(0, 0, 1), radius: 0.5 };
  assert.ok(Math.abs(turnOfRing(across, rayTo(0, 0, 0), rayTo(0.25, 0, 0.1)) - 0.5) < 1e-12);
  const aside = new Vector3(0, 0, 2);
  const moved = { ...across, middle: aside };
  const from = eye.clone().add(aside);
  assert.ok(Math.abs(turnOfRing(moved, rayTo(0, 0, 2, from), rayTo(-0.5, 0, 2, from)) + 1) < 1e-12);
});
