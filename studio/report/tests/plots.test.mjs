// SPDX-License-Identifier: Apache-2.0
// Plots, notes and keys of a report, in a browser.
import assert from 'node:assert/strict';
import { drawn } from './browser.mjs';
import { column, keysAt, method, reports, spread, turning } from './made.mjs';

const reportWith = reports();
const times = spread(21, 10);
const two = { keys: keysAt([0, 10], 0.1), methods: [method('a', turning(times, 0.1)), method('b', turning(times, 0.2))] };
const caption = (page, id) => page.locator(`[data-quantity=${id}] figcaption`).textContent();
const state = (page) => page.evaluate(() => viewer.current());
const how = (page) => page.locator('.plots > .facts').textContent();

reportWith('numbers of a column stand below each other in one power of ten', { ...two, columns: [column('cost', { unit: 'deg/s^2' })], methods: two.methods.map((one, i) => ({ ...one, measures: { cost: [8.21e-5, 0.001163][i] } })) }, async (page) => {
  assert.deepEqual(await page.locator('td.number').allTextContents(), ['0.08210', '1.16300']);
  assert.match(await page.locator('th[data-id=cost]').textContent(), /\[10⁻³ deg\/s²\]/);
});

const notes = ['One.', 'Two.', 'Three.'];
reportWith('more than two notes are folded, and warnings are not', { ...two, notes, warnings: ['Beware.'] }, async (page) => {
  assert.equal(await page.locator('.warning').isVisible(), true);
  assert.equal(await page.getByText('Three.').isVisible(), false);
  await page.getByText('3 notes').click();
  assert.equal(await page.getByText('Three.').isVisible(), true);
});
reportWith('two notes are not folded', { ...two, notes: notes.slice(0, 2) }, async (page) => assert.equal(await page.getByText('Two.').isVisible(), true));

reportWith('arrows step, Home and End jump, and menus keep their keys', two, async (page) => {
  const after = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    return (await state(page)).time;
  };
  await page.evaluate(() => viewer.choose({ time: 5 }));
  assert.ok(Math.abs((await after('ArrowRight')) - 5.1) < 1e-9);
  assert.ok(Math.abs((await after('ArrowLeft', 'ArrowLeft')) - 4.9) < 1e-9);
  assert.ok(Math.abs((await after('Shift+ArrowRight')) - 5.9) < 1e-9);
  assert.equal(await after('End'), 10);
  assert.equal(await after('Home'), 0);
  await page.locator('select.first').focus();
  assert.equal(await after('End'), 0);
});

reportWith('what the plots show is played again and again, until the zoom is reset', two, async (page) => {
  const reset = page.getByRole('button', { name: 'Reset zoom' });
  assert.equal(await reset.isVisible(), false);
  await page.evaluate(() => viewer.choose({ window: [2, 2.2], time: 2.19, speed: 10 }));
  assert.equal(await reset.isVisible(), true);
  const seen = await page.evaluate(
    () =>
      new Promise((done) => {
        const times = [];
        viewer.subscribe(['time'], ({ time }) => times.push(time) > 30 && done(times));
        viewer.choose({ playing: true });
      }),
  );
  await page.evaluate(() => viewer.choose({ playing: false }));
  assert.ok(seen.every((time) => time >= 2 && time <= 2.2));
  assert.ok(seen.some((time, i) => i > 0 && time < seen[i - 1]));
  await page.keyboard.press('End');
  assert.equal((await state(page)).time, 2.2);
  await reset.click();
  assert.deepEqual((await state(page)).window, [0, 10]);
  assert.equal(await reset.isVisible(), false);
});

const wild = { ...two, methods: [two.methods[0], method('wild', turning(times, 40))] };
reportWith('a plot is scaled to the first method, and says what goes on beyond it', wild, async (page) => {
  assert.match(await caption(page, 'w'), /wild goes on to 40\.00$/);
  await page.evaluate(() => viewer.choose({ first: 'wild', second: 'a' }));
  await drawn(page);
  assert.doesNotMatch(await caption(page, 'w'), /goes on/);
});

reportWith('a plot stays while methods change', two, async (page) => {
  const canvas = await page.locator('[data-quantity=w] canvas').elementHandle();
  const picture = () => canvas.evaluate((one) => one.toDataURL());
  const before = await picture();
  await page.evaluate(() => viewer.choose({ first: 'b', second: 'a' }));
  await drawn(page);
  assert.equal(await canvas.evaluate((one) => one.isConnected), true);
  assert.notEqual(await picture(), before);
});

reportWith('plots out of view are drawn too, and before them those in view', two, async (page) => {
  const busy = await page.evaluate(async () => {
    viewer.choose({ first: 'b', second: null });
    const before = document.querySelectorAll('figure[aria-busy]').length;
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    return [before, document.querySelectorAll('[data-quantity=angle][aria-busy]').length];
  });
  assert.deepEqual(busy, [5, 0]);
  await drawn(page);
  assert.equal(await page.locator('[aria-busy]').count(), 0);
});

reportWith('plots side by side are in line, however long their captions are', { ...wild, methods: wild.methods.map((one, i) => ({ ...one, name: `${i}${' long'.repeat(12)}` })) }, async (page) => {
  const boxes = await page.locator('.plots figure:visible .frame').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
  assert.equal(boxes[0], boxes[1]);
  assert.equal(boxes[2], boxes[3]);
});

reportWith('what is plotted is told, as it is drawn', two, async (page) => {
  const [angle, apart, none] = await page.evaluate(() => ['angle', 'apart', 'gone'].map((id) => viewer.plotted(id).map(({ label, t, values }) => ({ label, t: [...t], values: [...values] }))));
  assert.deepEqual(angle.map(({ label }) => label), ['b', 'a']);
  assert.ok(Math.abs(angle[0].values.at(-1) - (2 * 180) / Math.PI) < 1e-4);
  assert.equal(apart.length, 1);
  assert.ok(Math.abs(apart[0].values.at(-1) - 180 / Math.PI) < 1e-4);
  assert.deepEqual(none, []);
});

const slow = { ...two, methods: [method('cubic', turning([0, 10], 0.1, { w: [0, 0, 0, 0, 0, 0] }))] };
reportWith('values beside a plot are those of the cubic at the time', slow, async (page) => {
  await page.evaluate(() => viewer.choose({ time: 2.5 }));
  const u = 0.25;
  assert.match(await caption(page, 'angle'), new RegExp(`cubic ${((3 * u * u - 2 * u ** 3) * 180 / Math.PI).toPrecision(4).replace('.', '\\.')}`));
});

for (const count of [2000, 1e5])
  reportWith(`${count} keys are marked as far as there is room, which is said`, { ...two, keys: keysAt(spread(count, 10), 0.1) }, async (page) => {
    assert.match(await how(page), /Keys are marked where they are 12 px apart; zoom in to see all\./);
    await page.evaluate((width) => viewer.choose({ window: [5, 5 + width] }), 40 / count);
    await drawn(page);
    assert.equal(await page.locator('.plots > .facts').isVisible(), false);
  });

const marks = { label: 'rejected', t: spread(3000, 10), q: keysAt(spread(3000, 10), 0.1).q, error_deg: spread(3000, 1) };
const judged = [method('a', turning(times, 0.1, { error_deg: times.map(() => 0.5) }))];
reportWith('marks near each other are drawn as one, which is said', { ...two, methods: judged, marks }, async (page) => {
  assert.match(await how(page), /Of points nearer to each other than 7 px one is drawn\./);
});

reportWith('a few keys need no words', two, async (page) => assert.equal(await page.locator('.plots > .facts').isVisible(), false));
