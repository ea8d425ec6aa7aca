// SPDX-License-Identifier: Apache-2.0
// No drag of a key in a template makes the curve turn more than twice as far as slerp; and what turns farther, or jumps, is cured.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answers, bytesOf, example } from './engine.mjs';
import { readFileSync } from 'node:fs';
import { dice, moduleOf } from './modules.mjs';

const { templates, motion, findingsOf, remedied, movedInTime, timesForDrag, turnedInBody, withOwn, reachOf, ownParameters, withMethod } = await moduleOf(
  'document/templates.ts', 'store/findings.ts', 'edits/remedy.ts', 'edits/time.ts', 'edits/turn.ts', 'edits/parameters.ts', 'timeline/scale.ts', 'store/parameters.ts', 'edits/choice.ts');
const ask = answers();
const methods = ask.methods(null);
const methodOf = ({ first }) => methods.find(({ name }) => name === first.method);
const degree = Math.PI / 180;

const openedOf = ({ text, name, first, second }) => ask.open({ bytes: bytesOf(text), name, method: first, beside: second }).document;

/** What is found of the curve, which there is. */
function found(document) {
  const { first } = answersOfCurves(document);
  assert.ok(!('trouble' in first), first.trouble?.message);
  return findingsOf(document.keys, first, methodOf(document));
}
const answersOfCurves = (document) => {
  const told = ask.curves({ document, count: Math.max(600, 4 * document.keys.length + 1) });
  return { first: told.first === 'same' ? last.first : (last = told).first };
};
let last;

/** The keys turn as far as slerp does. */
function isCalm(document, what) {
  const { turn, need, spun } = found(document);
  assert.deepEqual(spun, [], what);
  assert.ok(turn <= 2 * need, `${what}: ${turn}°, where the keys turn ${need}°`);
}

for (const template of [motion, ...templates]) {
  const document = openedOf(template);
  const { keys } = document;
  test(`${template.title}: keys are dragged in time as far as it goes`, () => {
    for (const [i, { id }] of keys.entries()) {
      const { min, max } = timesForDrag(document, id, 0);
      const beyond = 0.05 * (keys.at(-1).t - keys[0].t); // of an end, as far as the timeline is seen
      for (const t of [Math.max(min, keys[0].t - beyond), Math.min(max, keys.at(-1).t + beyond)]) isCalm(movedInTime(document, id, t), `key ${i + 1} at ${t} s`);
    }
  });
  test(`${template.title}: keys are turned any way`, () => {
    const random = dice(7);
    for (const { id } of keys)
      for (const angle of [60, 120, 170]) {
        const axis = [random() - 0.5, random() - 0.5, random() - 0.5], size = Math.hypot(...axis);
        isCalm(turnedInBody(document, id, axis.map((part) => (part / size) * angle * degree)), `key ${id} by ${angle}°`);
      }
  });
  test(`${template.title}: bars are pulled to their ends`, () => {
    for (const { which, info } of ownParameters(document, methods))
      for (const { id } of keys) {
        const { low, high } = reachOf(keys.map(({ own }) => own[info.name] ?? info.default), info.default, info);
        for (const value of [low, high]) isCalm(withOwn(document, id, which, info, value), `${info.name} ${value} at key ${id}`);
      }
  });
  test(`${template.title} is as smooth as it goes, and says nothing is odd`, () => {
    const { spun, jumps } = found(document);
    assert.deepEqual([spun, jumps], [[], []]);
  });
}

test('a spin is found where it is, and the calmest method of the library cures it', () => {
  const text = readFileSync(example('camera_keys.csv'), 'utf8').replace('\n3.88,', '\n5.62,');
  const document = ask.open({ bytes: bytesOf(text), name: 'spin.csv' }).document;
  const { turn, need, spun } = found(document);
  assert.ok(turn > 1900 && turn < 2000, `${turn}`);
  assert.ok(need > 340 && need < 350, `${need}`);
  assert.ok(spun.includes(3) && spun.every((span) => span >= 1 && span <= 6), `${spun}`); // `auto` takes eight keys
  const remedy = ask.calmest({ keys: document.keys, choice: document.first, need: need * degree });
  assert.equal(remedy.choice.method, 'monotone');
  const after = remedied(document, remedy);
  assert.deepEqual([after.first, after.keys], [{ method: 'monotone', settings: {} }, document.keys]);
  const cured = found(after);
  assert.deepEqual(cured.spun, []);
  assert.ok(cured.turn < 1.1 * need);
  for (const method of methods.filter((one) => one.interpolates && one.continuity_uneven >= 1 && one.support_keys !== null)) {
    const other = found({ ...document, first: { method: method.name, settings: {} } });
    assert.ok(other.turn >= cured.turn - 1e-6, `${method.name} turns ${other.turn}°`);
  }
});

const atTime = (document, index, t) => movedInTime(document, document.keys[index].id, t);

test('a jump of a method for even times is found, and cured by the one that holds on any, with its tensions', () => {
  const document = atTime(openedOf(templates.find(({ first }) => first === 'quintic')), 2, 2.25);
  const { jumps } = found(document);
  assert.ok(jumps.includes(1) && jumps.includes(3), `${jumps}`);
  const remedy = ask.ofAnyTimes({ keys: document.keys, choice: document.first });
  assert.equal(remedy.choice.method, 'timed-c2');
  assert.ok(remedy.apart < 1e-9, `${remedy.apart}`); // the same curve at even times
  const after = remedied(document, remedy);
  assert.deepEqual(after.keys.map(({ own }) => own.tension), [0.1, 0.6, 0, 0.6, 0.1]);
  const { first } = answersOfCurves(after);
  assert.ok([...first.orders].every((order) => order >= 2), `${first.orders}`);
  assert.deepEqual(found(after).jumps, []);
});

for (const method of methods.filter((one) => one.interpolates && one.continuity_uneven < one.continuity_uniform))
  test(`for ${method.name} on uneven times another method is found that is as smooth there`, () => {
    const plain = openedOf(templates[0]);
    const document = atTime(withMethod({ ...plain, first: { method: method.name, settings: {} } }, 'first', method), 2, 2.25);
    const { jumps } = found(document);
    assert.ok(jumps.length > 0);
    const remedy = ask.ofAnyTimes({ keys: document.keys, choice: document.first });
    if (!remedy) return assert.ok(method.parameters.some(({ per_key }) => per_key)); // no other method has its values at keys
    assert.ok(remedy.order >= method.continuity_uniform);
    assert.deepEqual(found(remedied(document, remedy)).jumps, []);
  });
