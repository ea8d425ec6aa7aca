// SPDX-License-Identifier: Apache-2.0
// Reports with little in them. The template is the one that was built.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';

const template = readFileSync(new URL('../dist/index.html', import.meta.url), 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'orispline-page-'));
const nothing = { t: [], q: [], w: [], a: [], j: [], torque: [], p: [], error_t: [], error_deg: [] };
const two = { t: [0, 1], q: [1, 0, 0, 0, 0.8, 0, 0, 0.6] };
const samples = { ...two, w: [0, 0, 1, 0, 0, 1], a: [0, 0, 0, 0, 0, 0], j: [0, 0, 0, 0, 0, 0], torque: [], p: [], error_t: [], error_deg: [] };
const empty = {
  title: 'T',
  command: '',
  date: '',
  version: '',
  time_start: '',
  notes: [],
  body: 'box',
  keys: { ...two, p: [] },
  reference: null,
  marks: null,
  limits: {},
  columns: [{ id: 'cost', label: 'Cost', unit: '', explanation: '', better: 'less' }],
  sorted_by: '',
  methods: [],
};
const method = (name, more) => ({ name, continuity: 'C0', failure: '', measures: { cost: 1 }, samples, keys: null, ...more });

let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const reportWith = (name, changes, steps) =>
  test(name, async () => {
    const file = join(folder, 'report.html');
    writeFileSync(file, template.replace('__ORISPLINE_REPORT_DATA__', () => JSON.stringify({ ...empty, ...changes })));
    const page = await open(browser, file);
    await page.waitForTimeout(200);
    await steps(page);
    await page.finish();
  });

reportWith('without methods is a table without rows', {}, async (page) => {
  assert.equal(await page.locator('tbody tr').count(), 0);
  assert.equal(await page.locator('canvas').count(), 0);
});

reportWith('in which all methods failed shows why', { methods: [method('a', { failure: 'no', samples: nothing })] }, async (page) => {
  assert.equal(await page.locator('tr.failed td').last().textContent(), 'no');
  assert.equal(await page.locator('canvas').count(), 0);
});

reportWith('of one method without positions and without a reference shows it alone', { methods: [method('only')] }, async (page) => {
  assert.equal(await page.locator('.stages figure:visible').count(), 2);
  assert.equal(await page.locator('[data-quantity=error]').count(), 0);
  assert.equal(await page.locator('.controls label:has-text("Seen")').count(), 0);
});

const keys = { t: [0], q: [1, 0, 0, 0], p: [] };
const still = { t: [0], q: [1, 0, 0, 0], w: [0, 0, 0], a: [0, 0, 0], j: [0, 0, 0], torque: [], p: [], error_t: [], error_deg: [] };
reportWith('of one key has measures only', { keys, methods: [method('constant', { samples: still })] }, async (page) => {
  assert.equal(await page.locator('tbody tr').count(), 1);
  assert.equal(await page.locator('canvas').count(), 0);
});

const scattered = [method('gap', { measures: {} }), method('large', { measures: { cost: 9 } }), method('null', { measures: { cost: null } }), method('small', {})];
reportWith('sorts missing values to the end both ways', { methods: scattered, sorted_by: 'cost' }, async (page) => {
  const names = () => page.locator('tbody th').allTextContents();
  assert.deepEqual((await names()).slice(0, 2), ['small', 'large']);
  await page.locator('th[data-id=cost] button').click();
  assert.deepEqual((await names()).slice(0, 2), ['large', 'small']);
  assert.equal(await page.locator('td.number', { hasText: '–' }).count(), 2);
});

const count = 20000;
const times = Array.from({ length: count }, (_, k) => k / 100);
const crowd = { t: times, q: times.flatMap((t) => [Math.cos(t), 0, Math.sin(t), 0]), p: [] };
const long = { ...samples, t: [0, times.at(-1)] };
reportWith('of very many keys opens and plays', { keys: crowd, methods: [method('a', { samples: long })] }, async (page) => {
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('output').textContent) > 0.5, null, { timeout: 5000 });
});

const later = { ...samples, t: [0.25, 0.75], error_deg: [1, null] };
reportWith('of methods at other times shows both', { methods: [method('a'), method('b', { samples: later })] }, async (page) => {
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /a 1\.000/);
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /b 1\.000/);
});

/** How many pixels of a plot have about that colour, in a part of its width. */
const pixels = (page, quantity, colour, [from, to] = [0, 1]) =>
  page.locator(`[data-quantity=${quantity}] canvas`).evaluate(
    (canvas, { colour, from, to }) => {
      const { data } = canvas.getContext('2d').getImageData(from * canvas.width, 0, (to - from) * canvas.width, canvas.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) count += colour.every((value, k) => Math.abs(data[i + k] - value) < 16) && data[i + 3] > 200;
      return count;
    },
    { colour, from, to },
  );
const red = [0xb3, 0x26, 0x1e];
const grey = [0x7a, 0x7f, 0x87];

const heavy = { ...samples, torque: [0, 0, 2, 0, 0, 1] };
reportWith('with limits draws them where they belong', { methods: [method('a', { samples: heavy })], limits: { w: 1.5, torque: 3 } }, async (page) => {
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /limit 1\.500/);
  assert.match(await page.locator('[data-quantity=torque] figcaption').textContent(), /a 2\.000.*limit 3\.000/);
  assert.ok((await pixels(page, 'w', red)) > 100);
  assert.ok((await pixels(page, 'torque', red)) > 100); // above all values, and still in the picture
  assert.doesNotMatch(await page.locator('[data-quantity=a] figcaption').textContent(), /limit/);
  assert.equal(await pixels(page, 'a', red), 0);
});

const marks = { label: 'rejected', t: [0.5], q: [0, 0, 0, 1], error_deg: [30] };
const withErrors = { ...samples, error_t: [0, 0.25, 1], error_deg: [0, 7, 1] };
const noted = { methods: [method('a', { samples: withErrors }), method('b')], marks, notes: ['One sample is <b>rejected</b>.'] };
reportWith('with marks crosses them, and says its notes', noted, async (page) => {
  assert.equal(await page.locator('header p').last().textContent(), 'One sample is <b>rejected</b>.');
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /rejected/);
  assert.ok((await pixels(page, 'error', red)) > 10);
  await page.locator('input[type=range]').fill('0.3');
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /a 7\.000/); // at times of their own
  assert.doesNotMatch(await page.locator('[data-quantity=error] figcaption').textContent(), /b /);
});

const seven = { t: [0, 0.2, 0.4, 0.5, 0.6, 0.8, 1], q: Array.from({ length: 7 }, (_, i) => [Math.cos(i / 5), 0, 0, Math.sin(i / 5)]).flat(), p: [] };
reportWith('of methods with keys of their own marks those of the first', { methods: [method('a', { keys: seven }), method('b')] }, async (page) => {
  const picture = () => page.locator('[data-quantity=w] canvas').evaluate((canvas) => canvas.toDataURL());
  const withSeven = await picture();
  await page.locator('select.second').selectOption('');
  assert.notEqual(await picture(), withSeven);
  const alone = await picture();
  await page.locator('select.first').selectOption('b');
  assert.notEqual(await picture(), alone);
});

const gap = [null, null, null];
const broken = {
  ...nothing,
  t: [0, 0.25, 0.5, 0.75, 1],
  q: [1, 0, 0, 0, 0.8, 0, 0, 0.6, null, null, null, null, 0.6, 0, 0, 0.8, 0, 0, 0, 1],
  w: [0, 0, 1, 0, 0, 1, ...gap, 0, 0, 1, 0, 0, 1],
  a: [0, 0, 0, 0, 0, 0, ...gap, 0, 0, 0, 0, 0, 0],
  j: [0, 0, 0, 0, 0, 0, ...gap, 0, 0, 0, 0, 0, 0],
};
const pathWithGap = { t: broken.t, q: broken.q };
const zeros = Array(21).fill(0);
const whole = { ...samples, ...seven, w: zeros.map((_, i) => Number(i % 3 === 2)), a: zeros, j: zeros };
reportWith('with a gap shows nothing in it', { methods: [method('a', { samples: broken }), method('b', { samples: whole })], reference: pathWithGap }, async (page) => {
  const said = (quantity) => page.locator(`[data-quantity=${quantity}] figcaption`).textContent();
  const scene = page.locator('.stages figure.first .frame');
  await page.locator('input[type=range]').fill('0.1');
  assert.match(await said('w'), /a 1\.000/);
  const before = await scene.screenshot();
  await page.locator('input[type=range]').fill('0.5');
  await page.waitForTimeout(100);
  for (const quantity of ['angle', 'w', 'a', 'j']) assert.match(await said(quantity), /a –/);
  assert.match(await said('angle'), /reference –/);
  assert.ok((await pixels(page, 'angle', grey, [0.1, 0.3])) > 20);
  assert.equal(await pixels(page, 'angle', grey, [0.4, 0.7]), 0);
  assert.match(await said('w'), /b 1\.000/);
  assert.notDeepEqual(await scene.screenshot(), before);
});
