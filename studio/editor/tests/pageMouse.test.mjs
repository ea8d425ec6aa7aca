// SPDX-License-Identifier: Apache-2.0
// The built page, used by the mouse: keys are turned, moved, made, pulled, undone; both curves follow.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { about, five, studioWith, turnOf } from './wholePage.mjs';

const near = (some, others, most = 1e-9) => some.every((value, i) => Math.abs(value - others[i]) <= most);
const sorted = (turn) => turn.map(Math.abs).sort((a, b) => b - a);
/** Both signs are one orientation. */
const isTurnedTo = (q, wanted, most = 1e-9) => near(q, wanted, most) || near(q, wanted.map((value) => -value), most);

/** A place of the body's scene where a ring is under the mouse. */
async function ringOf(studio) {
  const middle = await studio.middle('Body');
  for (let x = middle.x + 40; x < middle.x + middle.width / 2; x += 3) {
    await studio.page.mouse.move(x, middle.y + 20);
    if ((await studio.scene('Body').evaluate(({ style }) => style.cursor)) === 'grab') return { x, y: middle.y + 20 };
  }
  assert.fail('found no ring');
}

test('a key is turned by a ring and by its dot on the sphere; the curves follow, and each pull is one step', async () => {
  const studio = await studioWith({ text: five });
  await studio.dot(3).click();
  await studio.drawn();
  const before = await studio.keys();
  const speed = () => studio.ask(({ view }) => view.methodNamed(view.current().first).samples.w.reduce((sum, w) => sum + w * w, 0));
  const was = await speed();
  const ring = await ringOf(studio);
  await studio.drag(ring, { x: ring.x - 15, y: ring.y + 70 });
  await studio.drawn();
  const turned = await studio.keys();
  const [most, rest] = sorted(turnOf(before[2].q, turned[2].q));
  assert.ok(most > 5 && rest < 1e-9, `${most} ${rest}`);
  assert.notEqual(await speed(), was);
  const from = await studio.handle(4);
  const middle = await studio.middle('Sphere');
  await studio.drag(from, middle, { x: middle.x + 30, y: middle.y - 20 });
  await studio.drawn();
  const to = await studio.handle(4);
  assert.ok(Math.hypot(to.x - middle.x - 30, to.y - middle.y + 20) < 1.5, JSON.stringify(to));
  assert.equal(await studio.chosen(), 4);
  assert.equal(await studio.time(), 4);
  assert.equal(await studio.stepsBack(), 2);
  assert.deepEqual(await studio.keys(), before);
  await studio.finish();
});

test('a key is turned by numbers: Euler angles in any order, a quaternion, a rotation vector', async () => {
  const studio = await studioWith({ text: five });
  await studio.dot(2).click();
  const form = studio.group('Key').getByRole('combobox', { name: 'Orientation as' });
  const q = async () => (await studio.keys())[1].q;
  const typed = async (...texts) => {
    const fields = studio.group('Key').locator('.fields').first().getByRole('textbox');
    for (const [i, text] of texts.entries()) await studio.type(fields.nth(i), text);
  };
  const chain = (...turns) => turns.reduce(([w, x, y, z], [a, b, c, d]) => [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a]);
  const [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (const [order, wanted] of [
    ['ZYX', chain(about(z, 40), about(y, -20), about(x, 75))],
    ['XYZ', chain(about(x, 40), about(y, -20), about(z, 75))],
    ['ZXZ', chain(about(z, 40), about(x, -20), about(z, 75))],
    ['xyz', chain(about(z, 75), about(y, -20), about(x, 40))],
  ]) {
    await form.selectOption(order);
    await typed('40', '-20', '75');
    assert.ok(isTurnedTo(await q(), wanted), `${order}: ${await q()}, wanted ${wanted}`);
  }
  await form.selectOption('quaternion');
  await typed('0', '0', '1', '0');
  await typed('0', '0', '1', '0'); // each number makes the four a unit quaternion
  assert.ok(isTurnedTo(await q(), [0, 0, 1, 0]), `${await q()}`);
  await form.selectOption('rotvec');
  await typed('0.3', '-1.2', '0.7');
  const size = Math.hypot(0.3, 1.2, 0.7);
  assert.ok(isTurnedTo(await q(), about([0.3, -1.2, 0.7], (size * 180) / Math.PI)), `${await q()}`);
  await studio.finish();
});

test('a key is dragged in time, never past a neighbour; a double click inserts one that lies on the curve', async () => {
  const studio = await studioWith({ text: five });
  await studio.dragBy(studio.dot(2), 60, 0);
  const [, t] = await studio.times();
  assert.ok(t > 1 && t < 2.5, t);
  assert.equal(await studio.time(), t);
  await studio.dragBy(studio.dot(2), 3000, 0);
  assert.ok((await studio.times())[1] < 2.5);
  await studio.button('Undo').click();
  await studio.button('Undo').click();
  await studio.drawn();
  assert.deepEqual(await studio.times(), [0, 1, 2.5, 4, 5]);
  assert.equal(await studio.button('Undo').isDisabled(), true);
  const before = await studio.ask(({ store }) => store.current().document);
  const { x, y } = await studio.centreOf(studio.dot(3));
  await studio.page.mouse.dblclick(x + 80, y);
  await studio.dot(6).waitFor();
  await studio.drawn();
  const { keys } = await studio.ask(({ store }) => store.current().document);
  assert.equal(await studio.chosen(), 4);
  const at = await studio.ask(({ engine }, { keys, choice, time }) => engine.ask('at', { keys, choice, time }), { keys: before.keys, choice: before.first, time: keys[3].t });
  assert.ok(near(keys[3].q, at.q, 1e-15), `${keys[3].q} ${at.q}`);
  await studio.button('Duplicate key').click();
  assert.equal((await studio.times()).length, 7);
  await studio.button('Delete key').click();
  await studio.button('Delete key').click();
  assert.equal((await studio.times()).length, 5);
  assert.equal(await studio.stepsBack(), 4);
  assert.deepEqual(await studio.ask(({ store }) => store.current().document), before);
  await studio.finish();
});

test('tension is pulled at one key by its bar, at all keys by the slider, each in one step', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2' });
  await studio.dragBy(studio.bar(3), 0, -14);
  const own = (await studio.keys()).map(({ own }) => own.tension);
  assert.ok(own[2] > 0.6, `${own}`);
  assert.deepEqual(own.toSpliced(2, 1), [0.5, 0.5, 0.5, 0.5]);
  const slider = studio.page.getByRole('slider', { name: 'All keys: tension' });
  const { x, y, width } = await studio.centreOf(slider);
  await studio.drag({ x, y }, { x: x + width / 4, y }, { x: x - width / 4, y });
  const all = (await studio.keys()).map(({ own }) => own.tension);
  assert.ok(all.every((value) => value === all[0] && value < own[2]), `${all}`);
  assert.equal(await studio.stepsBack(), 2);
  assert.deepEqual((await studio.keys()).map(({ own }) => own), [{}, {}, {}, {}, {}]);
  await studio.finish();
});

test('both curves are seen at once, with both sides and the order at each key', async () => {
  const studio = await studioWith({ text: five, method: 'slerp', beside: 'timed-c2' });
  assert.deepEqual(await studio.ask(({ view }) => view.methods.map(({ name }) => name)), ['Curve slerp', 'beside timed-c2']);
  const sides = await studio.ask(({ view }) => {
    const { t, w } = view.methodNamed('Curve slerp').samples;
    const left = t.indexOf(1);
    return [t[left + 1], [...w.slice(3 * left, 3 * left + 6)]];
  });
  assert.equal(sides[0], 1);
  assert.notDeepEqual(sides[1].slice(0, 3), sides[1].slice(3));
  for (const name of ['Body', 'Sphere']) assert.ok(await studio.scene(name).isVisible());
  assert.equal(await studio.group('Plots').locator('canvas:visible').count(), 4);
  const jumping = () => studio.page.locator('.dot.jumps').count();
  assert.equal(await jumping(), 3);
  await studio.dot(2).click();
  assert.match(await studio.group('Key').textContent(), /velocity jumps/);
  await studio.method('Curve').selectOption('timed-c2');
  await studio.drawn();
  assert.equal(await jumping(), 0);
  assert.match(await studio.group('Key').textContent(), /jerk jumps/);
  const apart = await studio.ask(({ view }) => view.methods.map(({ samples }) => samples.q.length));
  assert.equal(apart[0], apart[1]);
  await studio.finish();
});

test('parameters, choices and ends are set in a form made of what the library tells', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2' });
  await studio.button('Settings of Curve').click();
  const form = studio.dialog('Settings of Curve');
  await form.getByRole('combobox', { name: 'Start', exact: true }).selectOption('rest');
  await studio.type(form.getByRole('textbox', { name: 'tension', exact: true }), '0.25');
  await studio.keyboard.press('Escape');
  await studio.drawn();
  assert.equal(await studio.ask(({ view }) => view.current().first), 'Curve timed-c2:ends=rest,natural:tension=0.25');
  const speed = await studio.ask(({ view }) => view.methodNamed(view.current().first).samples.w.slice(0, 3).map(Math.abs));
  assert.ok(Object.values(speed).every((value) => value < 1e-9), JSON.stringify(speed));
  const names = await studio.ask(({ methods }) => methods.map(({ name }) => name));
  assert.ok(names.length > 15);
  for (const name of names) {
    await studio.method('Curve').selectOption(name);
    await studio.drawn();
    const { troubles } = await studio.ask(({ store }) => store.current());
    const refusal = studio.page.locator('.refusal.first');
    if (troubles.first) assert.match(await refusal.textContent(), /^\S+ has no curve through these keys: .*\. The last good one stays, in grey\.$/);
    else assert.equal(await refusal.isVisible(), false);
  }
  await studio.finish();
});

test('the table is written into as the timeline is pulled', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2' });
  await studio.button('Table').click();
  const table = studio.group('Keys');
  await studio.type(table.getByRole('textbox', { name: 'time of key 3' }), '3');
  await studio.type(table.getByRole('textbox', { name: 'tension of key 4' }), '0.9');
  await studio.type(table.getByRole('textbox', { name: /^Z, first turn of key 5/ }), '12.5');
  const keys = await studio.keys();
  assert.deepEqual([keys[2].t, keys[3].own.tension], [3, 0.9]);
  assert.equal(await studio.stepsBack(), 3);
  await studio.finish();
});
