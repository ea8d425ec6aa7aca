// SPDX-License-Identifier: Apache-2.0
// The report of the example flight in a browser: FLIGHT_PAGE names the file, PICTURES a folder for pictures of it.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { moduleOf } from '../../viewer/tests/built.mjs';
import { documentOf } from './document.mjs';
import { drawn, faultsOf, launch, open, phone, screens, tooWide } from './browser.mjs';

const file = process.env.FLIGHT_PAGE;
const data = documentOf(file);
const working = data.methods.filter((method) => !method.failure);
const { keys, methods } = (await moduleOf('data/document.ts')).readDocument(data);
const [timeStart, timeEnd] = [keys.t[0], keys.t.at(-1)];

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** A test with a page of its own. */
const onPage = (name, options, steps) =>
  test(name, async () => {
    const page = await open(browser, file, options);
    await steps(page);
    await page.finish();
  });

const clock = async (page) => Number.parseFloat(await page.locator('output').textContent());
const names = (page) => page.locator('tbody th').allTextContents();
const caption = (page, quantity) => page.locator(`[data-quantity=${quantity}] figcaption`).textContent();
const moveTo = (page, time) =>
  page.locator('input[type=range]').evaluate((input, value) => {
    input.value = value;
    input.dispatchEvent(new Event('input'));
  }, String(time));

/** The place of a time in a plot. */
async function placeIn(page, quantity, fraction) {
  const over = page.locator(`[data-quantity=${quantity}] .u-over`);
  await over.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await over.boundingBox();
  return { x: x + fraction * width, y: y + height / 2 };
}

const cursors = (page) =>
  page.locator('.plots figure:not([hidden]) .u-over').evaluateAll((plots) =>
    plots.map((over) => {
      const line = over.querySelector('.u-cursor-x').getBoundingClientRect();
      const box = over.getBoundingClientRect();
      return (line.left - box.left) / box.width;
    }),
  );

onPage('shows every method, and the reason why one failed, as plain text', {}, async (page) => {
  assert.equal(await page.title(), data.title);
  assert.equal(await page.locator('h1').textContent(), data.title);
  assert.equal(await page.locator('pre').textContent(), data.command);
  assert.equal(await page.locator('tbody tr').count(), data.methods.length);
  const failed = data.methods.filter((method) => method.failure);
  for (const { name, failure } of failed) assert.equal(await page.locator(`tr[data-method="${name}"] td`).last().textContent(), failure);
  assert.deepEqual((await names(page)).slice(working.length).sort(), failed.map(({ name }) => name).sort());
});

test('may not reach the network', async () => {
  const page = await open(browser, file);
  const reached = await page.evaluate(() => fetch('data:,x').then(() => true, () => false));
  assert.equal(reached, false);
  await page.close();
});

onPage('sorts the table by a click, down by a second one', {}, async (page) => {
  const byMax = [...working].sort((a, b) => a.measures.max_deg - b.measures.max_deg).map(({ name }) => name);
  const head = page.locator('th[data-id=max_deg]');
  await head.getByRole('button').click();
  assert.equal(await head.getAttribute('aria-sort'), 'ascending');
  assert.equal((await names(page))[0], byMax[0]);
  await head.getByRole('button').click();
  assert.equal(await head.getAttribute('aria-sort'), 'descending');
  const shown = await names(page);
  assert.equal(shown[0], byMax.at(-1));
  assert.equal(shown.length, data.methods.length);
  assert.ok(data.methods.find(({ name }) => name === shown.at(-1)).failure);
  await page.locator('th[data-id=name] button').click();
  assert.deepEqual((await names(page)).slice(0, working.length), working.map(({ name }) => name).sort((a, b) => a.localeCompare(b, 'en', { numeric: true })));
});

onPage('marks the best value of each measure', {}, async (page) => {
  const best = Math.min(...working.map((method) => method.measures.rms_deg));
  const winner = working.find((method) => method.measures.rms_deg === best).name;
  assert.ok(await page.locator(`tr[data-method="${winner}"] td.best`).count());
  const loser = working.find((method) => data.columns.every(({ id }) => working.some(({ measures }) => measures[id] < method.measures[id])));
  assert.equal(await page.locator(`tr[data-method="${loser.name}"] td.best`).count(), 0);
});

onPage('switches the methods from the table and from the menus', {}, async (page) => {
  const captions = () => page.locator('.stages figure:not([hidden]) figcaption').allTextContents();
  assert.deepEqual((await captions()).slice(0, 2), [working[0].name, working[1].name]);
  await page.locator('tr[data-method="slerp"] th').click();
  assert.equal((await captions())[0], 'slerp');
  assert.match(await caption(page, 'w'), /slerp/);
  await page.locator('select.second').selectOption('squad');
  assert.equal((await captions())[1], 'squad');
  assert.match(await caption(page, 'error'), /squad/);
  await page.locator('select.second').selectOption('');
  assert.equal((await captions()).length, 2);
  assert.equal(await page.locator('[data-quantity=apart]').isVisible(), false);
});

onPage('plays, pauses and goes on', { draws: true }, async (page) => {
  const scene = page.locator('.stages figure.first');
  await moveTo(page, timeStart + 15);
  await drawn(page);
  const before = await scene.screenshot();
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction((from) => Number.parseFloat(document.querySelector('output').textContent) > from + 0.5, timeStart + 15);
  await page.getByRole('button', { name: 'Pause' }).click();
  const paused = await clock(page);
  await drawn(page);
  assert.equal(await clock(page), paused);
  assert.notDeepEqual(await scene.screenshot(), before);
  await page.keyboard.press('Tab');
  await page.locator('h1').click();
  await page.keyboard.press('Space');
  await page.waitForFunction((from) => Number.parseFloat(document.querySelector('output').textContent) > from, paused);
});

onPage('begins again at the end', {}, async (page) => {
  await moveTo(page, timeEnd - 0.1);
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction((end) => Number.parseFloat(document.querySelector('output').textContent) < end / 2, timeEnd);
});

onPage('has one cursor in all plots and in the bar', {}, async (page) => {
  const { x, y } = await placeIn(page, 'w', 0.4);
  await page.mouse.move(x, y);
  await drawn(page);
  assert.ok(Math.abs((await clock(page)) - (timeStart + 0.4 * (timeEnd - timeStart))) < 0.1);
  const places = await cursors(page);
  assert.equal(places.length, 6);
  for (const place of places) assert.ok(Math.abs(place - 0.4) < 0.005, `${place}`);
});

onPage('follows the bar with the cursor, and says the values there', {}, async (page) => {
  const time = 0.7 * timeEnd + 0.3 * timeStart;
  await moveTo(page, time);
  for (const place of await cursors(page)) assert.ok(Math.abs(place - 0.7) < 0.005, `${place}`);
  const { t, w } = methods.find(({ name }) => name === working[0].name).samples;
  const next = t.findIndex((value) => value > time);
  const [before, after] = [next - 1, next].map((i) => Math.hypot(...w.slice(3 * i, 3 * i + 3)));
  const speed = before + ((after - before) * (time - t[next - 1])) / (t[next] - t[next - 1]);
  const said = Number.parseFloat(new RegExp(`${working[0].name} ([\\d.]+)`).exec(await caption(page, 'w'))[1]);
  assert.ok(Math.abs(said - speed) < 1e-3 * speed, `${said} ${speed}`);
});

onPage('shows a stretch of time in all plots, and all of it after a double click', {}, async (page) => {
  const [from, to] = [await placeIn(page, 'w', 0.25), await placeIn(page, 'w', 0.5)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  const elsewhere = await placeIn(page, 'a', 0.5);
  await page.mouse.move(elsewhere.x, elsewhere.y);
  await drawn(page);
  const middle = timeStart + 0.375 * (timeEnd - timeStart);
  assert.ok(Math.abs((await clock(page)) - middle) < 0.2, `${await clock(page)}`);
  await page.mouse.dblclick(elsewhere.x, elsewhere.y);
  await drawn(page);
  const again = await placeIn(page, 'angle', 0.25);
  await page.mouse.move(again.x, again.y);
  await drawn(page);
  assert.ok(Math.abs((await clock(page)) - (timeStart + 0.25 * (timeEnd - timeStart))) < 0.2);
});

onPage('draws other bodies, other axes and other places', { draws: true }, async (page) => {
  await moveTo(page, 16);
  const scenes = page.locator('.stages');
  const pictures = [];
  for (const [label, choice] of [['Body', 'aircraft'], ['Body', 'box'], ['Body', 'axes'], ['Seen', 'path'], ['Seen', 'fixed'], ['Axis', 'y'], ['Axis', 'z']]) {
    await page.locator(`.controls label:has-text("${label}") select`).selectOption(choice);
    await drawn(page);
    pictures.push((await scenes.screenshot()).toString('base64'));
  }
  assert.equal(new Set(pictures).size, pictures.length);
});

onPage('hides the components where they are not wanted', {}, async (page) => {
  assert.match(await caption(page, 'a'), /y [−\d]/);
  await page.getByLabel('Components').uncheck();
  assert.doesNotMatch(await caption(page, 'a'), /y [−\d]/);
});

const ground = (page) => page.evaluate(() => getComputedStyle(document.querySelector('.orispline-viewer')).backgroundColor);

onPage('is light or dark as the system says, and as the user says', { colorScheme: 'dark' }, async (page) => {
  assert.equal(await ground(page), 'rgb(14, 18, 23)');
  await page.getByRole('button', { name: 'Light' }).click();
  assert.equal(await ground(page), 'rgb(243, 245, 247)');
  await page.getByRole('button', { name: 'Dark' }).click();
  await page.emulateMedia({ colorScheme: 'light' });
  await page.waitForFunction(() => getComputedStyle(document.querySelector('.orispline-viewer')).backgroundColor === 'rgb(243, 245, 247)');
});

onPage('fits on a phone, and follows a finger', phone, async (page) => {
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.deepEqual(widths, [390, 390]);
  assert.deepEqual(await tooWide(page), []);
  const { x, y } = await placeIn(page, 'angle', 0.6);
  await page.touchscreen.tap(x, y);
  await drawn(page);
  assert.ok(Math.abs((await clock(page)) - (timeStart + 0.6 * (timeEnd - timeStart))) < 0.3);
});

for (const [name, options] of Object.entries(screens))
  onPage(`is accessible ${name}`, options, async (page) => assert.deepEqual(await faultsOf(page), []));

/** Whether all of an element is seen without scrolling, above the bar at the foot. */
const isOnFirstScreen = (locator) =>
  locator.evaluate((one) => {
    const { top, bottom, left, right } = one.getBoundingClientRect();
    return top >= 0 && left >= 0 && right <= innerWidth && bottom <= document.querySelector('.playback').getBoundingClientRect().top;
  });

onPage('has the table and the motion side by side on the first screen of a laptop', { viewport: { width: 1440, height: 900 } }, async (page) => {
  const [table, ...figures] = [page.locator('.measures'), ...(await page.locator('.stages figure').all())];
  assert.equal(figures.length, 3);
  for (const one of [table, ...figures]) assert.ok(await isOnFirstScreen(one));
  const box = await table.boundingBox();
  for (const figure of figures) assert.ok((await figure.boundingBox()).x >= box.x + box.width);
  assert.ok(box.height > 500);
});

onPage('keeps the names in view while the table is scrolled sideways', { viewport: { width: 660, height: 1000 } }, async (page) => {
  await page.locator('.measures').evaluate((one) => (one.scrollLeft = 400));
  const [table, name] = [await page.locator('.measures').boundingBox(), await page.locator('tbody th').first().boundingBox()];
  assert.ok(Math.abs(name.x - table.x) < 2);
});

const pictures = { light: { height: 1690 }, dark: { height: 1690, colorScheme: 'dark' }, phone: { width: 390, height: 844 } };
test('has its picture taken', { skip: !process.env.PICTURES }, async () => {
  for (const [name, { width = 1400, height, colorScheme }] of Object.entries(pictures)) {
    const page = await open(browser, file, { viewport: { width, height }, colorScheme, draws: true });
    await moveTo(page, 16);
    await drawn(page);
    await page.screenshot({ path: join(process.env.PICTURES, `${name}.png`) });
    await page.finish();
  }
});
