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
const nothing = { t: [], q: [], w: [], a: [], j: [], p: [], error_deg: [] };
const two = { t: [0, 1], q: [1, 0, 0, 0, 0.8, 0, 0, 0.6] };
const samples = { ...two, w: [0, 0, 1, 0, 0, 1], a: [0, 0, 0, 0, 0, 0], j: [0, 0, 0, 0, 0, 0], p: [], error_deg: [] };
const empty = {
  title: 'T',
  command: '',
  date: '',
  version: '',
  time_start: '',
  body: 'box',
  keys: { ...two, p: [] },
  reference: null,
  columns: [{ id: 'cost', label: 'Cost', unit: '', explanation: '', better: 'less' }],
  sorted_by: '',
  methods: [],
};
const method = (name, more) => ({ name, continuity: 'C0', failure: '', measures: { cost: 1 }, samples, ...more });

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
const still = { t: [0], q: [1, 0, 0, 0], w: [0, 0, 0], a: [0, 0, 0], j: [0, 0, 0], p: [], error_deg: [] };
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

const later = { ...samples, t: [0.25, 0.75], error_deg: [1, null] };
reportWith('of methods at other times shows both', { methods: [method('a'), method('b', { samples: later })] }, async (page) => {
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /a 1\.000/);
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /b 1\.000/);
});
