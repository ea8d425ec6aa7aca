// SPDX-License-Identifier: Apache-2.0
// Where times and values are on the timeline.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moduleOf } from './modules.mjs';

const { apart, marks, nearest, placeOf, reachOf, roundTime, slid, stepOf, timeAt, zoomed } = await moduleOf('timeline/scale.ts');

const scale = { from: 10, to: 14, width: 840 }; // 200 px are a second, and there are 20 beside the ends

test('a time and its place lead to each other', () => {
  assert.equal(placeOf(scale, 10), 20);
  assert.equal(placeOf(scale, 14), 820);
  for (const time of [9, 10, 11.25, 15]) assert.ok(Math.abs(timeAt(scale, placeOf(scale, time)) - time) < 1e-12);
});

test('one moment alone has a place too', () => assert.equal(placeOf({ from: 3, to: 3, width: 840 }, 3), 20));

test('a time that is dragged has few digits, and is not farther off than a pixel', () => {
  for (const time of [10.123456789, 11.99999, 13.5]) {
    const round = roundTime(scale, time);
    assert.ok(Math.abs(round - time) <= 0.005, round);
    assert.ok(String(round).length <= 6, round);
  }
});

test('marks are round, and at least 72 pixels apart', () => {
  for (const to of [10.02, 11, 14, 75, 4000]) {
    const times = marks({ ...scale, to });
    const places = times.map((time) => placeOf({ ...scale, to }, time));
    assert.ok(times.length >= 2 && times.length <= 12, `${to}: ${times}`);
    for (let i = 1; i < places.length; ++i) assert.ok(places[i] - places[i - 1] > 71.9, `${to}: ${times}`);
  }
});

test('keys that are too near to each other are left out, but not the one that is chosen', () => {
  const places = [0, 5, 10, 30, 33, 60];
  assert.deepEqual(apart(places, 12, -1), [0, 3, 5]);
  assert.deepEqual(apart(places, 12, 2), [2, 3, 5]);
  assert.deepEqual(apart(places, 12, 4), [0, 4, 5]);
  assert.equal(nearest(places, 32, 14), 4);
  assert.equal(nearest(places, 80, 14), -1);
});

test('the window is zoomed around a time, and never shows more than there is', () => {
  assert.deepEqual(zoomed([0, 10], [0, 10], 5, 0.5), [2.5, 7.5]);
  assert.deepEqual(zoomed([2, 4], [0, 10], 2, 100), [0, 10]);
  assert.deepEqual(slid([2, 4], [0, 10], 100), [8, 10]);
  assert.deepEqual(slid([2, 4], [0, 10], -100), [0, 2]);
});

test('bars have room above the values, and arrow keys a round step', () => {
  const tension = { min: -100, max: 100 };
  assert.deepEqual(reachOf([0.5, 0.5], 0.5, tension), { low: 0, high: 1 });
  assert.equal(stepOf(reachOf([0.5], 0.5, tension)), 0.05);
  const wide = reachOf([-2, 8], 0, tension);
  assert.ok(wide.low < -2 && wide.high > 8);
  assert.ok(reachOf([0], 0, tension).low < 0);
  assert.ok(reachOf([1], 1, { min: 1e-6, max: 1e6 }).low > 0);
});
