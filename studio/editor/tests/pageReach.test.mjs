// SPDX-License-Identifier: Apache-2.0
// The built page on a wide screen, a tablet and a phone, light and dark: within reach of everybody, in whatever is open.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faultsOf, screens, tooWide } from '../../report/tests/browser.mjs';
import { five, studioWith } from './wholePage.mjs';

const least = { mouse: 24, touch: 44 }; // [px]

/** What is pressed or pulled and is smaller than that; a box with its label. */
const tooSmall = (page, size) =>
  page.locator('button:visible, select:visible, input:visible, textarea:visible, [role=slider]:visible, a:visible').evaluateAll((all, size) =>
    all
      .map((one) => ({ one, box: (one.type === 'checkbox' ? one.closest('label') : one).getBoundingClientRect() }))
      .filter(({ box }) => Math.min(box.width, box.height) < size - 0.01)
      .map(({ one, box }) => `${box.width.toFixed(1)} x ${box.height.toFixed(1)}: ${one.outerHTML.slice(0, 100)}`), size);

async function check(studio, what, size) {
  await studio.page.evaluate(() => Promise.all(document.getAnimations().filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity).map(({ finished }) => finished.catch(() => {})))); // what arrives is pale until then
  const faults = (await faultsOf(studio.page)).filter((fault) => !fault.startsWith('minor'));
  assert.deepEqual(faults, [], what);
  assert.deepEqual(await tooWide(studio.page), [], what);
  assert.ok(await studio.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), what);
  assert.deepEqual(await tooSmall(studio.page, size), [], what);
}

const popups = ['Settings of Curve', 'Settings of Compare with', 'Copy', 'Export'];

/** All that can be opened, one after another. */
async function* opened(studio) {
  for (const name of popups) {
    await studio.button(name).click();
    yield name;
    await studio.keyboard.press('Escape');
  }
  await studio.button('Help').click();
  yield 'Help';
  await studio.keyboard.press('Escape');
  for (const [menu, item] of [['Copy', 'C++'], ['Export', 'Samples'], ['Export', 'Curve for the player']]) {
    await studio.button(menu).click();
    await studio.page.getByRole('menuitem', { name: item }).click();
    await studio.page.locator('dialog[open]').waitFor();
    yield item;
    await studio.keyboard.press('Escape');
    await studio.page.locator('dialog[open]').waitFor({ state: 'detached' });
  }
}

for (const [name, options] of Object.entries(screens)) {
  const size = options.hasTouch ? least.touch : least.mouse;
  test(`nothing is out of reach ${name}`, async () => {
    const start = await studioWith({}, options);
    await check(start, 'start', size);
    await start.finish();
    const studio = await studioWith({ text: five, name: 'a_rather_long_name_of_a_file_that_somebody_gave_to_keys.csv', method: 'timed-c2' }, options);
    await check(studio, 'editor', size);
    await studio.dot(3).click();
    await studio.method('Curve').selectOption('bezier');
    await studio.drawn();
    await studio.button('Table').click();
    await studio.drop('bad.csv', 'no keys');
    await studio.page.locator('.notice').waitFor();
    await studio.page.evaluate(() => scrollTo(0, 0)); // a notice lies upon what is at the foot of the screen
    await check(studio, 'table, a refused method and a notice', size);
    await studio.button('Close this notice').click();
    await studio.type(studio.field('time'), '1/0');
    await check(studio, 'a refused number', size);
    await studio.finish();
  });
}

for (const name of ['on a wide screen', 'on a phone in the dark'])
  test(`nothing that is opened is out of reach ${name}`, async () => {
    const options = screens[name];
    const studio = await studioWith({ text: five, method: 'timed-c2' }, options);
    for await (const what of opened(studio)) await check(studio, what, options.hasTouch ? least.touch : least.mouse);
    const rows = Array.from({ length: 1001 }, (_, i) => `${i},1,0,0,0`).join('\n');
    await studio.drop('long.csv', `t,qw,qx,qy,qz\n${rows}`);
    await studio.dialog('Too many keys to edit').waitFor();
    await check(studio, 'reduce', options.hasTouch ? least.touch : least.mouse);
    await studio.keyboard.press('Escape');
    await studio.finish();
  });
