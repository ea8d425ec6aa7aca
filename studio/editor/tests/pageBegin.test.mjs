// SPDX-License-Identifier: Apache-2.0
// How one begins on the built page: with the command's keys, a file that is picked, dropped or pasted, or a template.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { phone } from '../../report/tests/browser.mjs';
import { five, placeOf, studioWith, withDisk } from './wholePage.mjs';

test('the keys of the command are there at once, with its methods', async () => {
  const studio = await studioWith({ text: five, name: 'mine.csv', method: 'timed-c2:tension=0.3', beside: 'squad' });
  assert.deepEqual(await studio.times(), [0, 1, 2.5, 4, 5]);
  const { first, second } = await studio.ask(({ store }) => store.current().document);
  assert.deepEqual([first, second], [{ method: 'timed-c2', settings: { tension: 0.3 } }, { method: 'squad', settings: {} }]);
  assert.equal(await studio.page.title(), 'mine.csv – orispline studio');
  assert.equal(await studio.ask(({ store }) => store.current().isSaved), true);
  await studio.finish();
});

for (const [title, name, count] of [['Five keys', 'five_keys.csv', 5], ['A camera', 'camera_keys.csv', 12], ['The flight', 'flight_keys.csv', 38], ['Tensions of a paper', 'five_tensions.csv', 5]]) {
  test(`${title}, a template, is begun by mouse and by keyboard`, async () => {
    const studio = await studioWith();
    const card = studio.page.getByRole('button', { name: title });
    if (count === 12) await card.click();
    else {
      while (!(await card.evaluate((one) => one === document.activeElement))) await studio.keyboard.press('Tab');
      await studio.keyboard.press('Enter');
    }
    await studio.isOpen(name);
    assert.equal((await studio.keys()).length, count);
    await studio.finish();
  });
}

test('a template is begun by touch', async () => {
  const studio = await studioWith({}, phone);
  await studio.tap(studio.page.getByRole('button', { name: 'Tensions of a paper' }));
  await studio.isOpen('five_tensions.csv');
  assert.deepEqual((await studio.keys()).map(({ own }) => own.tension), [0.1, 0.6, 0, 0.6, 0.1]);
  await studio.finish();
});

test('a file is dropped, and another one on that', async () => {
  const studio = await studioWith();
  await studio.drop('dropped.csv', five);
  await studio.isOpen('dropped.csv');
  await studio.drop('second.csv', five.replace('\n5,', '\n7,'));
  await studio.isOpen('second.csv');
  assert.deepEqual(await studio.times(), [0, 1, 2.5, 4, 7]);
  await studio.finish();
});

test('a text is pasted anywhere, or typed into a field', async () => {
  const studio = await studioWith();
  await studio.paste(five);
  await studio.isOpen('pasted.csv');
  assert.equal((await studio.keys()).length, 5);
  await studio.paste(five.replace('\n5,', '\n8,'));
  await studio.page.waitForFunction(() => window.studio.current.studio.store.current().document.keys.at(-1).t === 8);
  await studio.finish();
  const other = await studioWith();
  await other.button('Paste…').click();
  await other.page.getByRole('textbox', { name: 'Keys as CSV' }).fill(five);
  await other.button('Use this text').click();
  await other.isOpen('pasted.csv');
  await other.finish();
});

test('a file is picked: by a file chooser, or by what gives access to the disk', async () => {
  const file = placeOf('chosen.csv');
  writeFileSync(file, five);
  const studio = await studioWith({}, { first: () => delete globalThis.showOpenFilePicker });
  const [chooser] = await Promise.all([studio.page.waitForEvent('filechooser'), studio.button('Open a file…').click()]);
  await chooser.setFiles(file);
  await studio.isOpen('chosen.csv');
  await studio.finish();
  const other = await studioWith({}, { first: withDisk });
  await other.page.evaluate((text) => Object.assign(window, { disk: { 'disk.csv': text }, picked: 'disk.csv' }), five);
  await other.button('Open a file…').click();
  await other.isOpen('disk.csv');
  await other.page.evaluate((text) => Object.assign(window, { disk: { 'more.csv': text }, picked: 'more.csv' }), five);
  await other.keyboard.press('Control+o');
  await other.isOpen('more.csv');
  await other.finish();
});

test('the plots call the two methods as all of the page does', async () => {
  const studio = await studioWith({ text: five });
  const text = await studio.page.getByRole('group', { name: 'Plots' }).innerText();
  for (const wanted of ['Components x, y, z of the curve', 'Angle between both curves', 'Curve auto', 'beside slerp']) assert.ok(text.includes(wanted), text);
  assert.doesNotMatch(text, /first method|two methods/);
  await studio.finish();
});

test('a file opens also while what is open is edited, and the same file opens with its edits', async () => {
  const studio = await studioWith({ text: five });
  await studio.page.evaluate(async (text) => {
    const { store } = window.studio.current.studio;
    const edit = () => {
      const { document } = store.current();
      store.edit({ ...document, keys: document.keys.with(1, { ...document.keys[1], t: document.keys[1].t + 0.001 }) });
    };
    let isOpen = false;
    const opened = window.studio.open({ bytes: new TextEncoder().encode(text), name: 'next.csv' }).then(() => (isOpen = true));
    while (!isOpen) {
      edit();
      await new Promise((resolve) => setTimeout(resolve));
    }
    await opened;
  }, five.replace('\n5,', '\n9,'));
  await studio.isOpen('next.csv');
  await studio.dot(2).focus();
  await studio.keyboard.press('ArrowRight');
  const times = await studio.times();
  await studio.page.evaluate((text) => window.studio.open({ bytes: new TextEncoder().encode(text), name: 'next.csv' }), five.replace('\n5,', '\n9,'));
  await studio.notice(/from before are here again/).waitFor();
  assert.deepEqual(await studio.times(), times);
  await studio.finish();
});
