// SPDX-License-Identifier: Apache-2.0
// What is drawn between the samples.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleOf } from './built.mjs';

let motion, lines, polyline;
before(async () => {
  motion = await moduleOf('motion/orientation.ts');
  lines = await moduleOf('motion/lines.ts');
  ({ polyline } = await moduleOf('motion/polyline.ts'));
});

const list = (values) => Float64Array.from(values.flat());
const about = ([x, y, z], angle) => [Math.cos(angle / 2), ...[x, y, z].map((value) => value * Math.sin(angle / 2))];
const angle = (a, b) => (2 * Math.acos(Math.min(Math.abs(a.reduce((sum, value, k) => sum + value * b[k], 0)), 1)) * 180) / Math.PI;
const axis = [0.6, 0, 0.8];

/** Turns about one axis by a function of the time, at these times. */
const turning = (times, turned, speed) => ({ t: list(times), q: list(times.map((t) => about(axis, turned(t)))), w: list(times.map((t) => axis.map((value) => value * speed(t)))) });

test('a turn whose angle is a cubic of the time is met exactly', () => {
  const [turned, speed] = [(t) => 0.3 * t - t * t + 0.7 * t ** 3, (t) => 0.3 - 2 * t + 2.1 * t * t];
  const path = turning([0, 0.5, 2], turned, speed);
  for (const t of [0, 0.1, 0.5, 0.6, 1.3, 2]) assert.ok(angle(motion.orientationAt(path, t), about(axis, turned(t))) < 1e-5, `${t}`);
});

test('the cubic goes through both samples with both rates, about any axes', () => {
  const path = { t: list([0, 0.5]), q: list([about([1, 0, 0], 0.2), about([0, 0.6, 0.8], 0.9)]), w: list([[0.4, -1, 2], [1.5, 0.3, -0.7]]) };
  const step = 1e-6;
  for (const [i, t, side] of [[0, 0, 1], [1, 0.5, -1]]) {
    const [here, near] = [motion.orientationAt(path, t), motion.orientationAt(path, t + side * step)];
    const at = Array.from(path.q.subarray(4 * i, 4 * i + 4));
    assert.ok(angle(here, at) < 1e-5);
    const [w, x, y, z] = at;
    const [a, b, c, d] = near.map((value) => value * Math.sign(near.reduce((sum, v, k) => sum + v * at[k], 0)));
    const turn = [w * b - x * a - y * d + z * c, w * c + x * d - y * a - z * b, w * d - x * c + y * b - z * a];
    turn.forEach((value, k) => assert.ok(Math.abs((2 * side * value) / step - path.w[3 * i + k]) < 1e-4));
  }
});

test('without rates the way is the shorter arc, at a constant rate', () => {
  const path = { t: list([0, 2]), q: list([about(axis, 0), about(axis, 1).map((value) => -value)]) };
  for (const u of [0, 0.25, 0.7, 1]) assert.ok(angle(motion.orientationAt(path, 2 * u), about(axis, u)) < 1e-5);
});

test('so it is where a rate turns by more than ten turns in a third of the step', () => {
  const path = turning([0, 7000], (t) => t / 7000, () => 1);
  assert.ok(angle(motion.orientationAt(path, 1750), about(axis, 0.25)) < 1e-5);
  assert.ok(lines.anglesFromStart(path).t.length < 10);
});

test('at a time that stands twice the right side is shown, and nothing in a gap', () => {
  const jump = { t: list([0, 1, 1, 2]), q: list([about(axis, 0), about(axis, 1), about(axis, 2), about(axis, 3)]) };
  assert.ok(angle(motion.orientationAt(jump, 1), about(axis, 2)) < 1e-5);
  assert.ok(angle(motion.orientationAt(jump, 0.999999), about(axis, 1)) < 1e-3);
  const gap = { t: list([0, 1, 2, 3]), q: list([about(axis, 0), about(axis, 1), [NaN, NaN, NaN, NaN], about(axis, 3)]) };
  assert.deepEqual([0, 0.5, 1, 1.5, 2, 2.5, 3].map((t) => motion.isShownAt(gap, t)), [true, true, true, false, false, false, true]);
});

test('a clock is linear between its times, and stands still outside', () => {
  const clock = { t: list([0, 2, 4]), own: list([0, 1, 5]) };
  assert.deepEqual([-1, 0, 1, 3, 4, 5].map((t) => motion.ownTime(clock, t)), [0, 0, 0.5, 3, 5, 5]);
  assert.equal(motion.ownTime(null, 7), 7);
});

/** The largest distance between a polyline and what it stands for, within its pieces. */
function farthest({ t, values }, exact) {
  let most = 0;
  for (let i = 0; i + 1 < t.length; ++i)
    for (let k = 1; k < 20; ++k) {
      const u = k / 20;
      most = Math.max(most, Math.abs((1 - u) * values[i] + u * values[i + 1] - exact((1 - u) * t[i] + u * t[i + 1])));
    }
  return most;
}

test('the chords of an angle from the start are within 0.005 degrees', () => {
  const times = [0, 0.4, 1, 1.7, 2.5, 3];
  const path = turning(times, (t) => 0.2 + 3 * Math.sin(2 * t), (t) => 6 * Math.cos(2 * t));
  const start = motion.orientationAt(path, 0);
  const drawn = lines.anglesFromStart(path);
  assert.ok(farthest(drawn, (t) => angle(start, motion.orientationAt(path, t))) < 0.005);
  for (const t of times) assert.ok(drawn.t.includes(t));
  assert.ok(drawn.t.length < 2000, `${drawn.t.length}`);
});

test('so are those of the angle between two motions, at whichever times they are sampled', () => {
  const one = turning([0, 1, 2, 3], (t) => t * t, (t) => 2 * t);
  const other = turning([0.5, 0.9, 1.3, 2.2], (t) => t ** 3, (t) => 3 * t * t);
  const drawn = lines.anglesApart(one, other);
  const shown = { t: [], values: [] };
  drawn.t.forEach((t, i) => !Number.isNaN(drawn.values[i]) && (shown.t.push(t), shown.values.push(drawn.values[i])));
  assert.deepEqual([shown.t[0], shown.t.at(-1)], [0.5, 2.2]); // where both are
  assert.ok(farthest(shown, (t) => (Math.abs(Math.asin(Math.sin((t * t - t ** 3) / 2))) * 360) / Math.PI) < 0.005);
});

test('the way over the sphere is a chord within 0.005 degrees too', () => {
  const path = turning([0, 1, 2], (t) => t, () => 1);
  const { t, values } = lines.wayOverSphere(path, 'x');
  for (let i = 0; i + 1 < t.length; ++i) {
    const middle = [0, 1, 2].map((k) => (values[3 * i + k] + values[3 * i + 3 + k]) / 2);
    assert.ok(1 - Math.hypot(...middle) < (0.005 * Math.PI) / 180);
  }
});

test('a polyline has both sides of a jump, and a break in a gap', () => {
  const { t, values } = polyline(list([0, 1, 1, 2, 3, 4]), (i) => (i === 3 ? null : () => [i]), 0.1);
  assert.deepEqual(Array.from(t), [0, 1, 1, 2, 2.5, 3, 4]);
  assert.deepEqual(Array.from(values), [0, 0, 2, 2, NaN, 4, 4]);
});
