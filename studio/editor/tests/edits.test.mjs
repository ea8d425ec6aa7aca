// SPDX-License-Identifier: Apache-2.0
// Each edit by itself: what it changes, and what it leaves.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { documentOf, keysOfAngles, moduleOf, shoemake, tcb, tension, timedC2 } from './modules.mjs';

const sources = ['turn', 'time', 'keys', 'position', 'parameters', 'choice', 'reasons'];
const edits = await moduleOf(...sources.map((name) => `edits/${name}.ts`), 'document/keys.ts');

const frozen = (value) => {
  if (typeof value === 'object' && value !== null && !Object.isFrozen(value)) Object.values(Object.freeze(value)).forEach(frozen);
  return value;
};

const four = frozen(documentOf(keysOfAngles([0, 0.5, 1, 1.5])));
const near = (found, wanted) => found.forEach((number, i) => assert.ok(Math.abs(number - wanted[i]) < 1e-15, `${found} is not ${wanted}`));
const changedKeys = (next, before) => next.keys.filter((key) => !before.keys.includes(key)).map(({ id }) => id);

test('a turn in the world frame stands on the left, one in the body frame on the right', () => {
  const half = Math.SQRT1_2;
  const upright = frozen(documentOf(keysOfAngles([0, Math.PI / 2])));
  const inWorld = edits.turnedInWorld(upright, 2, [Math.PI / 2, 0, 0]);
  const inBody = edits.turnedInBody(upright, 2, [Math.PI / 2, 0, 0]);
  near(inWorld.keys[1].q, [0.5, 0.5, -0.5, 0.5]);
  near(inBody.keys[1].q, [0.5, 0.5, 0.5, 0.5]);
  near(upright.keys[1].q, [half, 0, 0, half]);
  assert.deepEqual(changedKeys(inBody, upright), [2]);
});

test('a turn leaves rates, which are in the body frame, and all else of the key', () => {
  const keys = keysOfAngles([0, 1], () => ({ p: [1, 2, 3], rates: [[1, 2, 3], [NaN, NaN, NaN]], own: { tension: 0.25 } }));
  const { q, ...others } = edits.turnedInBody(documentOf(keys), 2, [0, 0.1, 0]).keys[1];
  const { q: before, ...same } = keys[1];
  assert.deepEqual(others, same);
  assert.notDeepEqual(q, before);
});

test('an orientation is scaled to norm 1, a fixed point of scaling', () => {
  const { q } = edits.turnedTo(four, 2, [3, 1, -2, 7]).keys[1];
  near([Math.hypot(...q)], [1]);
  assert.deepEqual(edits.normalised(q), q);
  const once = edits.turnedTo(four, 2, q);
  assert.equal(edits.turnedTo(once, 2, q), once);
});

test('of the two signs a key takes the one nearer to the key before, and those after it follow', () => {
  const { keys } = edits.turnedTo(four, 3, [-Math.cos(0.5), 0, 0, -Math.sin(0.5)]);
  near(keys[2].q, four.keys[2].q);
  const far = edits.turnedInWorld(four, 2, [0, 0, 2.9]);
  for (const [i, key] of far.keys.entries()) if (i > 0) assert.ok(edits.alignment(far.keys[i - 1].q, key.q) >= 0, `key ${i}`);
});

test('what is no orientation turns nothing', () => {
  for (const q of [[0, 0, 0, 0], [NaN, 0, 0, 1], [Infinity, 0, 0, 1]]) assert.equal(edits.turnedTo(four, 2, q), four);
  assert.equal(edits.turnedInWorld(four, 2, [NaN, 0, 0]), four);
  assert.equal(edits.turnedInWorld(four, 99, [1, 0, 0]), four);
  assert.equal(edits.turnedTo(four, 2, four.keys[1].q), four);
});

test('a key never passes a neighbour, nor touches it', () => {
  for (const [t, wanted] of [[1.25, 1.25], [-7, 'min'], [0, 'min'], [2, 'max'], [Infinity, 'max']]) {
    const range = edits.timesFor(four, 2);
    const moved = edits.movedInTime(four, 2, t);
    assert.equal(moved.keys[1].t, wanted === 'min' || wanted === 'max' ? range[wanted] : wanted);
    assert.ok(0 < moved.keys[1].t && moved.keys[1].t < 2);
    assert.deepEqual(changedKeys(moved, four), [2]);
  }
  assert.equal(edits.movedInTime(four, 2, NaN), four);
  assert.equal(edits.movedInTime(four, 2, 1), four);
  assert.equal(edits.movedInTime(four, 1, -3).keys[0].t, -3);
  assert.equal(edits.movedInTime(four, 4, 30).keys[3].t, 30);
});

test('keys that stand closer than any may be moved to stay where they are', () => {
  const close = documentOf(keysOfAngles([0, 1, 2], (i) => ({ t: [0, 1e-17, 1][i] })));
  const { min, max } = edits.timesFor(close, 2);
  assert.ok(min === 1e-17 && max < 1 && max > 0.99);
  assert.equal(edits.movedInTime(close, 2, 1e-17), close);
});

test('a key is inserted on the curve, with values of its own between those of its neighbours', () => {
  const own = documentOf(keysOfAngles([0, 1, 2], (i) => ({ rates: [[0, 0, 1]], own: { tension: [0, 1, 1][i] } })));
  const { document, id } = edits.inserted(own, 0.25, { q: [-2, 0, 0, -0.5], p: null });
  assert.deepEqual(document.keys.map(({ t }) => t), [0, 0.25, 1, 2]);
  const [, key] = document.keys;
  assert.equal(key.id, id);
  assert.equal(key.row, null);
  assert.equal(key.own.tension, 0.25);
  assert.deepEqual(key.rates, [[NaN, NaN, NaN]]);
  assert.ok(key.q[0] > 0);
  assert.equal(edits.inserted(own, 1.5, { q: [1, 0, 0, 0], p: null }).document.keys[2].own.tension, 1);
  assert.equal(edits.inserted(own, 9, { q: [1, 0, 0, 0], p: null }).document.keys[3].t, 9);
});

test('nothing is inserted onto a key, at no time, or without a direction', () => {
  for (const [t, q] of [[1, [1, 0, 0, 0]], [1 + 1e-12, [1, 0, 0, 0]], [NaN, [1, 0, 0, 0]], [0.5, [0, 0, 0, 0]], [0.5, [NaN, 0, 0, 1]]]) {
    const { document, id } = edits.inserted(four, t, { q, p: null });
    assert.equal(document, four);
    assert.equal(id, null);
  }
});

test('an inserted key has a position where the others have one', () => {
  const placed = documentOf(keysOfAngles([0, 1], (i) => ({ p: [i, 0, 0] })));
  assert.deepEqual(edits.inserted(placed, 0.5, { q: [1, 0, 0, 0], p: [7, 8, 9] }).document.keys[1].p, [7, 8, 9]);
  assert.equal(edits.inserted(four, 0.5, { q: [1, 0, 0, 0], p: [7, 8, 9] }).document.keys[1].p, null);
});

test('a copy stands in the middle to the next key, that of the last one a step later', () => {
  const { document, id } = edits.duplicated(four, 2);
  assert.deepEqual(document.keys.map(({ t }) => t), [0, 1, 1.5, 2, 3]);
  assert.equal(document.keys[2].id, id);
  assert.deepEqual(document.keys[2].q, four.keys[1].q);
  assert.equal(edits.duplicated(four, 4).document.keys[4].t, 4);
});

test('an id is never used again, not after its key was deleted', () => {
  const one = edits.duplicated(four, 2);
  const without = edits.deleted(one.document, one.id);
  const two = edits.duplicated(without, 2);
  assert.ok(two.id > one.id);
});

test('two keys are left at least', () => {
  const three = edits.deleted(four, 2);
  assert.deepEqual(three.keys.map(({ id }) => id), [1, 3, 4]);
  const two = edits.deleted(three, 1);
  assert.equal(edits.deleted(two, 3), two);
  assert.match(edits.notDeleted(two), /Insert another one first\.$/);
  assert.equal(edits.deleted(four, 99), four);
});

test('the first value of its own gives every key that of all', () => {
  const set = edits.withSetting(four, 'first', timedC2, 'tension', 0.25);
  const { keys, first } = edits.withOwn(set, 2, 'first', tension, 0.75);
  assert.deepEqual(keys.map(({ own }) => own.tension), [0.25, 0.75, 0.25, 0.25]);
  assert.deepEqual(first.settings, {});
  assert.deepEqual(edits.withOwn(four, 1, 'second', tension, 9e9).keys.map(({ own }) => own.tension), [100, 0.5, 0.5, 0.5]);
  assert.equal(edits.withOwn(four, 1, 'first', tension, NaN), four);
});

test('one value for all keys is a setting where keys have none of their own', () => {
  assert.deepEqual(edits.withValueForAll(four, 'second', tension, 0.3).second.settings, { tension: 0.3 });
  const own = edits.withOwn(four, 2, 'first', tension, 0.75);
  const all = edits.withValueForAll(own, 'first', tension, 0.3);
  assert.deepEqual(all.keys.map((key) => key.own.tension), [0.3, 0.3, 0.3, 0.3]);
  assert.deepEqual(all.first.settings, {});
  assert.equal(edits.withValueForAll(all, 'first', tension, 0.3), all);
  assert.deepEqual(edits.withoutOwn(all, 'tension').keys.map((key) => key.own), [{}, {}, {}, {}]);
});

test('a method keeps the settings that it knows, and drops others', () => {
  let document = edits.withSetting(four, 'first', timedC2, 'tension', 0.25);
  document = edits.withSetting(document, 'first', timedC2, 'tension2', 3);
  document = edits.withSetting(document, 'first', timedC2, 'ends', 'natural,rest');
  document = edits.withSetting(document, 'first', timedC2, 'closed', true);
  assert.deepEqual(document.first.settings, { tension: 0.25, tension2: 3, closed: true }); // a loop has no ends
  assert.deepEqual(edits.withMethod(document, 'first', tcb).first, { method: 'tcb', settings: { tension: 0.25 } });
  assert.equal(edits.withMethod(document, 'first', timedC2), document);
  const swapped = edits.exchanged(document);
  assert.deepEqual([swapped.first, swapped.second], [document.second, document.first]);
});

test('a setting that the method refuses changes nothing', () => {
  for (const [name, value] of [['tension', 101], ['tension', NaN], ['ends', 'handle'], ['timing', 'time'], ['closed', 1], ['other', 1]])
    assert.equal(edits.withSetting(four, 'first', timedC2, name, value), four, name);
  const timed = edits.withSetting(edits.withMethod(four, 'second', shoemake), 'second', shoemake, 'timing', 'published');
  assert.deepEqual(timed.second.settings, { timing: 'published' });
  assert.deepEqual(edits.withSetting(timed, 'second', shoemake, 'timing').second.settings, {});
});

test('a position is moved where keys have one', () => {
  const document = documentOf(keysOfAngles([0, 1], () => ({ p: [1, 2, 3] })));
  assert.deepEqual(edits.placed(document, 1, 1, -5).keys[0].p, [1, -5, 3]);
  assert.equal(edits.placed(document, 1, 1, NaN), document);
  assert.equal(edits.placed(document, 1, 1, Infinity).keys[0].p[1], 1e18);
  assert.equal(edits.placed(four, 1, 1, 5), four);
});

test('what is typed is a decimal number, or a sentence says what it should be', () => {
  for (const [text, number] of [['1.5', 1.5], [' -.5 ', -0.5], ['\u22123', -3], ['1e3', 1000], ['+2.', 2]]) assert.equal(edits.numberIn(text), number);
  for (const text of ['', 'abc', '1/0', '0x10', '1,5', '1e999', 'NaN', 'Infinity', '3 m']) {
    assert.equal(edits.numberIn(text), null);
    assert.match(edits.notANumber(text), /^Found “.*”, wanted a number/);
  }
  assert.match(edits.notATime(four, 2, 2), /^Found the time 2 s, wanted one between its neighbours/);
  assert.equal(edits.notATime(four, 2, 1.5), null);
  assert.match(edits.notAValue(tension, 200), /wanted -100 to 100/);
  assert.match(edits.notAQuaternion([0, 0, 0, 0]), /not all 0/);
});
