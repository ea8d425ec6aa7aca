// SPDX-License-Identifier: Apache-2.0
// The first minute on the built page: it opens in motion, shows around once, has few controls, and says and cures what is odd.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { example, studioWith } from './wholePage.mjs';

const opens = async (options = {}) => {
  const studio = await studioWith({}, options);
  await studio.page.getByRole('region', { name: 'Begin' }).waitFor();
  await studio.drawn();
  return studio;
};
const isPlaying = (studio) => studio.ask(({ view }) => view.current().playing);
const goesOn = (studio) => studio.page.waitForFunction(() => {
  const { view } = window.studio?.current?.studio ?? {};
  return view?.current().playing && view.current().time > view.current().extent[0] + 0.2;
});

test('it opens in motion, under its own name; a key is dragged at once, and nothing is unsaved before', async () => {
  const studio = await opens();
  await studio.page.getByRole('heading', { name: 'orispline studio', level: 1 }).waitFor();
  assert.equal(await studio.page.title(), 'orispline studio');
  assert.match(await studio.page.getByRole('region', { name: 'Begin' }).innerText(), /Orange jerks at each key, blue does not: drag a key\./);
  await goesOn(studio);
  assert.deepEqual(await studio.ask(({ store, view }) => [store.current().document.first.method, store.current().document.second.method, view.current().body, store.current().isSaved]), ['auto', 'slerp', 'aircraft', true]);
  const before = await studio.keys();
  const from = await studio.handle(1);
  const middle = await studio.middle('Sphere');
  await studio.drag(from, { x: (from.x + middle.x) / 2 + 20, y: (from.y + middle.y) / 2 });
  await studio.drawn();
  assert.notDeepEqual(await studio.keys(), before);
  assert.equal(await isPlaying(studio), false);
  await studio.finish();
});

test('nothing moves for those who want no motion', async () => {
  const studio = await opens({ reducedMotion: 'reduce' });
  const time = await studio.time();
  for (let i = 0; i < 5; ++i) await studio.frames();
  assert.deepEqual([await isPlaying(studio), await studio.time()], [false, time]);
  await studio.finish();
});

test('it rests while nobody sees it', async () => {
  const studio = await opens();
  await goesOn(studio);
  const hide = (is) =>
    studio.page.evaluate((is) => {
      Object.defineProperty(document, 'hidden', { get: () => is, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    }, is);
  await hide(true);
  assert.equal(await isPlaying(studio), false);
  await hide(false);
  assert.equal(await isPlaying(studio), true);
  await studio.keyboard.press(' ');
  await hide(true);
  await hide(false);
  assert.equal(await isPlaying(studio), false);
  await studio.finish();
});

test('a tour of five steps is there for who is new, by keyboard too; it is left, and not shown again', async () => {
  const studio = await opens({ new: true });
  const card = studio.dialog(/^Tour/);
  await card.waitFor();
  await studio.keyboard.press('Tab');
  assert.ok(await card.evaluate((one) => one.contains(document.activeElement)));
  await card.getByRole('button', { name: 'Next' }).focus();
  for (let step = 1; step <= 5; ++step) {
    await studio.dialog(`Tour: Step ${step} of 5`).waitFor();
    assert.equal(await studio.page.locator('.is-toured').count(), 1);
    await studio.keyboard.press('Enter');
  }
  await card.waitFor({ state: 'hidden' });
  assert.equal(await studio.page.locator('.is-toured').count(), 0);
  await studio.page.reload();
  await goesOn(studio);
  assert.equal(await card.isVisible(), false);
  await studio.button('Tour').click();
  await card.waitFor();
  await studio.keyboard.press('ArrowRight');
  await studio.dialog('Tour: Step 2 of 5').waitFor();
  await studio.keyboard.press('Escape');
  await card.waitFor({ state: 'hidden' });
  await studio.finish();
});

test('a dozen controls are there, the others with More, which is remembered', async () => {
  const studio = await opens({ new: true });
  await studio.page.getByRole('button', { name: 'Leave' }).click();
  const controls = () => studio.page.locator('.top, .caption, .timeline > .title, .plots > .controls, .playback, .key-panel').locator('button:visible, select:visible, input:not(.number):visible').count();
  assert.equal(await controls(), 12);
  await studio.button('More').click();
  assert.ok((await controls()) > 20);
  for (const name of ['Copy', 'Export', 'Table', 'Duplicate key']) assert.ok(await studio.button(name).isVisible(), name);
  await studio.page.reload();
  await studio.button('Table').waitFor();
  await studio.button('More').click();
  assert.equal(await controls(), 12);
  await studio.finish();
});

const advice = (studio) => studio.page.locator('.advice:visible');

test('a spin is said, marked, and cured by a button, in one step', async () => {
  const studio = await studioWith({ text: example('camera_keys.csv'), name: 'camera_keys.csv' });
  assert.equal(await advice(studio).count(), 0);
  await studio.dot(5).click();
  await studio.type(studio.field('time'), '5.62');
  await studio.drawn();
  await advice(studio).getByText('auto turns 5.6 times as far as the keys need, ').waitFor();
  assert.ok((await studio.page.locator('.spun').count()) > 0);
  await studio.button('Use monotone').click();
  await studio.drawn();
  assert.equal(await advice(studio).count(), 0);
  assert.equal(await studio.page.locator('.spun').count(), 0);
  assert.equal((await studio.ask(({ store }) => store.current().document.first)).method, 'monotone');
  await studio.button('Undo').click();
  await studio.drawn();
  await advice(studio).getByText(/spins/).waitFor();
  assert.equal(await studio.stepsBack(), 1);
  await studio.finish();
});

test('a drag to a neighbour stops where both are seen and nothing spins', async () => {
  const studio = await studioWith({ text: example('camera_keys.csv'), name: 'camera_keys.csv' });
  const [from, to] = [await studio.centreOf(studio.dot(5)), await studio.centreOf(studio.dot(6))];
  await studio.page.mouse.move(from.x, from.y);
  await studio.page.mouse.down();
  await studio.page.mouse.move(to.x, to.y, { steps: 5 });
  await studio.page.locator('.stops.is-held').waitFor();
  await studio.page.mouse.up();
  await studio.drawn();
  assert.ok((await studio.centreOf(studio.dot(6))).x - (await studio.centreOf(studio.dot(5))).x >= 19);
  assert.equal(await advice(studio).count(), 0);
  assert.equal(await studio.page.locator('.stops').isVisible(), false);
  await studio.finish();
});

test('a jump is said, and cured by the method of that kind which holds; it goes on with the tensions and says what they do', async () => {
  const studio = await opens();
  await studio.button('Tensions of a paper').click();
  await studio.isOpen('five_tensions.csv');
  assert.equal(await advice(studio).count(), 0);
  await studio.dot(3).click();
  await studio.type(studio.field('time'), '2.25');
  await studio.drawn();
  await advice(studio).getByText(/^quintic is smooth on even times only/).waitFor();
  await studio.button('Use timed-c2').click();
  await studio.drawn();
  assert.equal(await advice(studio).count(), 0);
  await studio.notice(/timed-c2 goes on with each tension as it was\. 0 rests at the key/).waitFor();
  assert.deepEqual((await studio.keys()).map(({ own }) => own.tension), [0.1, 0.6, 0, 0.6, 0.1]);
  assert.equal(await studio.page.locator('.dot.jumps').count(), 0);
  assert.equal(await studio.stepsBack(), 2);
  await studio.finish();
});

test('a bar says what it does, where the pointer is and where the focus is; that of tcb is the opposite', async () => {
  const studio = await opens();
  await studio.button('Tensions of a paper').click();
  await studio.isOpen('five_tensions.csv');
  const tip = studio.page.locator('.tip');
  await studio.bar(2).hover();
  assert.match(await tip.innerText(), /^tension of key 2: 0\.6\. 0 rests at the key, a larger one passes it faster and looser\.$/);
  await studio.page.mouse.move(5, 5);
  await tip.waitFor({ state: 'hidden' });
  await studio.method('Curve').selectOption('tcb');
  await studio.drawn();
  await studio.bar(3).focus();
  assert.match(await tip.innerText(), /the opposite/);
  await studio.finish();
});
