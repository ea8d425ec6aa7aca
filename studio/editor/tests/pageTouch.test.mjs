// SPDX-License-Identifier: Apache-2.0
// The built page on a phone, used by a finger.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { phone } from '../../report/tests/browser.mjs';
import { five, studioWith, turnOf, withDisk } from './wholePage.mjs';

const onPhone = (name, given, steps, options = {}) =>
  test(name, async () => {
    const studio = await studioWith(given, { ...phone, ...options });
    await steps(studio);
    await studio.finish();
  });

/** Where it is when it is in the middle of the screen. */
async function inView(studio, locator) {
  await locator.evaluate((one) => one.scrollIntoView({ block: 'center', behavior: 'instant' }));
  return studio.centreOf(locator);
}

onPhone('a finger turns a key on the sphere and by a ring, and the page stays', { text: five }, async (studio) => {
  await inView(studio, studio.scene('Sphere'));
  const scrolled = await studio.page.evaluate(() => scrollY);
  const before = await studio.keys();
  const from = await studio.handle(3);
  const middle = await studio.middle('Sphere');
  await studio.finger({ x: from.x + 10, y: from.y + 10 }, { x: middle.x + 20, y: middle.y - 30 });
  await studio.drawn();
  assert.equal(await studio.chosen(), 3);
  assert.equal(await studio.page.evaluate(() => scrollY), scrolled);
  const turned = await studio.keys();
  assert.ok(Math.hypot(...turnOf(before[2].q, turned[2].q)) > 3);
  await inView(studio, studio.scene('Body'));
  const body = await studio.middle('Body');
  const radius = (0.3 * Math.min(body.width, body.height)) / 2;
  await studio.finger({ x: body.x, y: body.y + radius }, { x: body.x + 50, y: body.y + radius + 10 });
  await studio.drawn();
  const turn = turnOf(turned[2].q, (await studio.keys())[2].q).map(Math.abs).sort((a, b) => b - a);
  assert.ok(turn[0] > 3 && turn[1] < 1e-9, `${turn}`);
  assert.equal(await studio.stepsBack(), 2);
  assert.deepEqual(await studio.keys(), before);
});

onPhone('a finger moves a key in time, pulls its tension, and makes, doubles and deletes keys', { text: five, method: 'timed-c2' }, async (studio) => {
  const dot = await inView(studio, studio.dot(2));
  await studio.finger(dot, { x: dot.x + 40, y: dot.y });
  const [, t] = await studio.times();
  assert.ok(t > 1 && t < 2.5, t);
  const far = await studio.centreOf(studio.dot(2));
  await studio.finger(far, { x: far.x + 900, y: far.y });
  assert.ok((await studio.times())[1] < 2.5);
  await studio.tap(studio.button('Undo'));
  const bar = await inView(studio, studio.bar(3));
  await studio.finger({ x: bar.x, y: bar.y + 10 }, { x: bar.x, y: bar.y - 8 });
  assert.ok((await studio.keys())[2].own.tension > 0.6);
  await studio.ask(({ view }) => view.moveTo(3.2));
  await studio.tap(studio.button('Insert key'));
  await studio.dot(6).waitFor();
  assert.equal((await studio.times())[3], 3.2);
  await studio.tap(studio.button('Duplicate key'));
  await studio.tap(studio.button('Delete key'));
  await studio.tap(studio.button('Delete key'));
  assert.equal((await studio.times()).length, 5);
  await studio.tap(studio.button('Undo'));
  await studio.tap(studio.button('Redo'));
  assert.equal(await studio.stepsBack(), 6);
});

onPhone('two taps beside the keys insert one', { text: five }, async (studio) => {
  const { x, y } = await inView(studio, studio.dot(3));
  do {
    for (let taps = 0; taps < 2; ++taps) await studio.page.touchscreen.tap(x + 40, y);
    await studio.frames();
  } while ((await studio.times()).length === 5); // a busy page may miss one of them
  await studio.dot(6).waitFor();
});

onPhone('fields, menus, settings, the table and texts to copy are within reach of a finger', { text: five, method: 'timed-c2' }, async (studio) => {
  await studio.dot(2).tap();
  await studio.tap(studio.field('Y, second turn'));
  await studio.type(studio.field('Y, second turn'), '33');
  await studio.method('Compare with').selectOption('squad');
  await studio.tap(studio.button('Settings of Curve'));
  await studio.dialog('Settings of Curve').getByRole('combobox', { name: 'End', exact: true }).selectOption('rest');
  await studio.page.touchscreen.tap(5, 5);
  await studio.tap(studio.button('Table'));
  await studio.type(studio.group('Keys').getByRole('textbox', { name: 'time of key 3' }), '3');
  await studio.tap(studio.button('Copy'));
  await studio.tap(studio.page.getByRole('menuitem', { name: 'Python' }));
  assert.match(await studio.dialog(/^Python/).getByRole('textbox').inputValue(), /ends=natural,rest/);
  await studio.tap(studio.dialog(/^Python/).getByRole('button', { name: 'Close' }));
  await studio.tap(studio.button('Export'));
  await studio.tap(studio.page.getByRole('menuitem', { name: 'Samples' }));
  const { name, text } = await studio.download(() => studio.tap(studio.dialog(/^Samples/).getByRole('button', { name: 'Export' })));
  assert.deepEqual([name, text.trim().split('\n').length], ['keys_samples.csv', 601]);
  const saved = await studio.download(() => studio.tap(studio.button('Save')));
  assert.match(saved.text, /^3,/m);
  await studio.tap(studio.button('Play'));
  await studio.page.waitForFunction(() => window.studio.current.studio.view.current().time > 3);
  await studio.tap(studio.button('Pause'));
});

onPhone('a file is opened by a finger', {}, async (studio) => {
  await studio.page.evaluate((text) => Object.assign(window, { disk: { 'disk.csv': text }, picked: 'disk.csv' }), five);
  await studio.tap(studio.button('Open a file…'));
  await studio.isOpen('disk.csv');
}, { first: withDisk });
