// SPDX-License-Identifier: Apache-2.0
// The built page, used by the keyboard alone. Nothing in here touches a mouse, and what has the focus was reached by Tab.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { five, studioWith, turnOf } from './wholePage.mjs';

const most = 120; // presses of Tab

async function tabTo(studio, locator, key = 'Tab') {
  for (let presses = 0; presses < most; ++presses) {
    if (await locator.evaluate((one) => one === document.activeElement)) return;
    await studio.keyboard.press(key);
  }
  assert.fail(`Tab does not lead to ${locator}`);
}

async function written(studio, field, text) {
  await tabTo(studio, field);
  await studio.keyboard.press('Control+a');
  await studio.keyboard.type(text);
  await studio.keyboard.press('Enter');
}

test('a key is turned about the axes of the screen, by 1°, 10° and 0.1°, on the body and on the sphere', async () => {
  const studio = await studioWith({ text: five });
  await studio.keyboard.press(']');
  assert.equal(await studio.chosen(), 2);
  for (const name of ['Body', 'Sphere']) {
    await tabTo(studio, studio.scene(name));
    for (const [key, angle] of [['ArrowRight', 1], ['Shift+ArrowUp', 10], ['Control+ArrowLeft', 0.1], ['PageUp', 1], ['Shift+PageDown', 10], ['Control+PageUp', 0.1]]) {
      const [, { q: before }] = await studio.keys();
      await studio.keyboard.press(key);
      const [, { q }] = await studio.keys();
      assert.ok(Math.abs(Math.hypot(...turnOf(before, q)) - angle) < 1e-9, `${name} ${key}`);
    }
  }
  await studio.keyboard.press('Control+z');
  await studio.drawn();
  await studio.finish();
});

test('a key is chosen, moved in time, made, doubled and deleted; all of it is undone and done again', async () => {
  const studio = await studioWith({ text: five });
  await tabTo(studio, studio.dot(1));
  await studio.keyboard.press('ArrowDown');
  await studio.keyboard.press('ArrowRight');
  assert.equal((await studio.times())[1], 1.05);
  await studio.keyboard.press('Shift+ArrowRight');
  assert.equal((await studio.times())[1], 1.55);
  for (let i = 0; i < 4; ++i) await studio.keyboard.press('Shift+ArrowRight');
  assert.ok((await studio.times())[1] < 2.5); // never past its neighbour
  await studio.keyboard.press('Control+ArrowLeft');
  await studio.keyboard.press('End');
  assert.equal(await studio.chosen(), 5);
  await studio.keyboard.press('Control+d');
  assert.deepEqual((await studio.times()).slice(4), [5, 6]);
  await studio.keyboard.press('Delete');
  await studio.keyboard.press('Home');
  await tabTo(studio, studio.button('Play'), 'Shift+Tab');
  await studio.keyboard.press('ArrowRight');
  const time = await studio.time();
  assert.ok(time > 0 && time < 1);
  await studio.keyboard.press('i');
  await studio.dot(6).waitFor();
  assert.deepEqual((await studio.times()).slice(0, 2), [0, time]);
  const steps = await studio.ask(({ store }) => JSON.stringify(store.current().document));
  for (let undone = 0; undone < 10; ++undone) await studio.keyboard.press('Control+z');
  assert.deepEqual(await studio.times(), [0, 1, 2.5, 4, 5]);
  for (let redone = 0; redone < 10; ++redone) await studio.keyboard.press(redone % 2 ? 'Control+y' : 'Control+Shift+z');
  assert.equal(await studio.ask(({ store }) => JSON.stringify(store.current().document)), steps);
  await studio.finish();
});

test('elsewhere arrows step the time, the space bar plays, Home and End jump', async () => {
  const studio = await studioWith({ text: five });
  await studio.keyboard.press('Home');
  await studio.keyboard.press('ArrowRight');
  assert.equal(await studio.time(), 0.05);
  await studio.keyboard.press('Shift+ArrowRight');
  assert.equal(await studio.time(), 0.55);
  await studio.keyboard.press('End');
  assert.equal(await studio.time(), 5);
  await studio.keyboard.press('Home');
  await studio.keyboard.press(' ');
  await studio.page.waitForFunction(() => studio.current.studio.view.current().time > 0.1);
  await studio.keyboard.press(' ');
  assert.equal(await studio.ask(({ view }) => view.current().playing), false);
  assert.deepEqual(await studio.times(), [0, 1, 2.5, 4, 5]);
  await studio.finish();
});

test('tension is set at one key and at all, by bar, slider and field', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2' });
  const tension = async () => (await studio.keys()).map(({ own }) => own.tension);
  await studio.keyboard.press(']');
  await tabTo(studio, studio.page.getByRole('slider', { name: 'All keys: tension' }));
  await studio.keyboard.press('ArrowRight');
  const setting = await studio.ask(({ store }) => store.current().document.first.settings.tension);
  assert.ok(setting > 0.5 && setting < 0.55, setting);
  await tabTo(studio, studio.dot(2));
  await studio.keyboard.press('Tab');
  assert.equal(await studio.bar(2).evaluate((one) => one === document.activeElement), true);
  await studio.keyboard.press('ArrowUp');
  const [one, two] = await tension();
  assert.ok(one === setting && two > setting, `${one} ${two}`);
  await written(studio, studio.field('tension'), '0.125');
  assert.deepEqual(await tension(), [setting, 0.125, setting, setting, setting]);
  await studio.finish();
});

test('numbers are typed into fields and into the table', async () => {
  const studio = await studioWith({ text: five });
  await studio.keyboard.press(']');
  await written(studio, studio.field('time'), '1.25');
  await written(studio, studio.field('X, third turn'), '-30');
  await studio.keyboard.press('ArrowUp');
  assert.equal(await studio.field('X, third turn').inputValue(), '-29');
  await tabTo(studio, studio.button('Table'), 'Shift+Tab');
  await studio.keyboard.press('Enter');
  await written(studio, studio.group('Keys').getByRole('textbox', { name: 'time of key 4' }), '3.5');
  assert.deepEqual(await studio.times(), [0, 1.25, 2.5, 3.5, 5]);
  await studio.finish();
});

test('methods are chosen, their settings set, and menus and dialogs opened and left', async () => {
  const studio = await studioWith({ text: five });
  await tabTo(studio, studio.method('Curve'));
  await studio.keyboard.type('timed-c2');
  await studio.page.waitForFunction(() => window.studio.current.studio.store.current().document.first.method === 'timed-c2');
  await tabTo(studio, studio.button('Settings of Curve'));
  await studio.keyboard.press('Enter');
  await written(studio, studio.dialog('Settings of Curve').getByRole('textbox', { name: 'tension', exact: true }), '0.75');
  await studio.keyboard.press('Escape');
  assert.deepEqual(await studio.ask(({ store }) => store.current().document.first.settings), { tension: 0.75 });
  assert.equal(await studio.button('Settings of Curve').evaluate((one) => one === document.activeElement), true);
  await tabTo(studio, studio.button('Copy'), 'Shift+Tab');
  await studio.keyboard.press('Enter');
  await studio.page.waitForFunction(() => document.activeElement.textContent === 'Command');
  await studio.keyboard.press('ArrowDown');
  await studio.keyboard.press('Enter');
  const copied = studio.dialog(/^C\+\+/);
  assert.match(await copied.getByRole('textbox').inputValue(), /timed-c2/);
  await studio.keyboard.press('Escape');
  await copied.waitFor({ state: 'detached' });
  await studio.keyboard.press('?');
  const help = studio.dialog('Keyboard');
  await help.waitFor();
  await studio.keyboard.press('Delete'); // sleeps meanwhile
  await studio.keyboard.press('Escape');
  await help.waitFor({ state: 'detached' });
  assert.equal((await studio.times()).length, 5);
  await studio.finish();
});

test('every key of the keyboard that is listed does what the list says', async () => {
  const studio = await studioWith({ text: five });
  await studio.keyboard.press('?');
  await studio.dialog('Keyboard').waitFor();
  const listed = await studio.dialog('Keyboard').locator('dt').allTextContents();
  for (const key of ['Ctrl+Z', 'Ctrl+S', 'Ctrl+O', 'Ctrl+D', '[', ']', 'I', 'Delete, Backspace', '?', 'Space', 'Page Up, Page Down']) assert.ok(listed.includes(key), key);
  const manual = readFileSync(join(process.env.ORISPLINE_EXAMPLES, '../../docs/studio.md'), 'utf8').split('## Keyboard')[1].split('\n## ')[0];
  const told = manual.split('\n').filter((line) => /^\|(?!--| where)/.test(line)).map((line) => line.split(' | ').at(-2).replace(/^\| /, ''));
  const inSections = await studio.dialog('Keyboard').locator('section:not(:last-child) dt').allTextContents(); // behind them are no keys
  assert.deepEqual(inSections.sort(), told.sort());
  await studio.keyboard.press('Escape');
  await studio.dialog('Keyboard').waitFor({ state: 'detached' });
  await studio.keyboard.press(']');
  const { name, text } = await studio.download(() => studio.keyboard.press('Control+s'));
  assert.deepEqual([name, text], ['keys.csv', five]);
  await studio.finish();
});
