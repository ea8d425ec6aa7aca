// SPDX-License-Identifier: Apache-2.0
// Pages whose data are in each form that is read, and those that are in none. The template is the one that was built.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { f2, f4, f8, u4 } from '../../viewer/tests/encoded.mjs';
import { drawn, faultsOf, launch, open } from './browser.mjs';

const template = readFileSync(new URL('../dist/index.html', import.meta.url), 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'orispline-data-'));
const file = join(folder, 'report.html');

let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const pageOf = (name, text, steps, options) =>
  test(name, async () => {
    writeFileSync(file, template.replace('__ORISPLINE_REPORT_DATA__', () => text.replaceAll('<', '\\u003c')));
    const page = await open(browser, file, options);
    await drawn(page);
    await steps(page);
    await page.finish();
  });

test('the template has one place for the data', () => assert.equal(template.split('__ORISPLINE_REPORT_DATA__').length, 2));

const head = { title: 'A <b>title</b>', date: '2030-01-01', version: '9.0', notes: ['A note.'] };
const broken = { 'without data': ['', /no data/], 'that is the template': ['__ORISPLINE_REPORT_DATA__', /no data/], 'whose data are cut off': ['{"title": "T", "meth', /not JSON/], 'whose data are a list': ['[1]', /no report/] };
for (const [name, [text, sentence]] of Object.entries(broken))
  pageOf(`a page ${name} says so`, text, async (page) => {
    assert.match(await page.locator('.warning').textContent(), sentence);
    assert.equal(await page.locator('h1').textContent(), 'orispline report');
    assert.equal(await page.locator('canvas, table').count(), 0);
    assert.deepEqual(await faultsOf(page), []);
  });

const unreadable = { 'of a later version': [{ ...head, data: 3, methods: 'of another kind' }, /version 3, wanted version 2 or an older one/], 'with a list in no known form': [{ ...head, data: 2, keys: { t: { f3: '' }, q: [], p: [] } }, /a form that is not known/] };
for (const [name, [data, sentence]] of Object.entries(unreadable))
  pageOf(`data ${name} are said to be that, below the title`, JSON.stringify(data), async (page) => {
    assert.equal(await page.locator('h1').textContent(), head.title);
    assert.match(await page.locator('.warning').textContent(), sentence);
    assert.match(await page.locator('.facts').first().textContent(), /orispline 9\.0/);
    assert.equal(await page.locator('.facts').last().textContent(), 'A note.');
    assert.equal(await page.locator('canvas, table').count(), 0);
  });

const times = Array.from({ length: 21 }, (_, i) => i / 20);
const turned = (speed) => ({
  q: times.flatMap((t) => [Math.cos((speed * t) / 2), 0, 0, Math.sin((speed * t) / 2)]),
  w: times.flatMap(() => [0, 0, speed]),
  a: times.flatMap(() => [0, 0, 0]),
  j: times.flatMap(() => [0, 0, 0]),
});
const none = { torque: [], p: [], error_t: [], error_deg: [] };
const keys = { t: [0, 1], q: [1, 0, 0, 0, 0.8, 0, 0, 0.6], p: [] };
const method = (name, samples, more = {}) => ({ name, continuity: 'C2', failure: '', measures: {}, samples: { ...none, ...samples }, keys: null, ...more });
const asArrays = { keys, methods: [method('a', { t: times, ...turned(1) }), method('b', { t: times, ...turned(0.5) })] };

const typed = (samples, t) => ({ t, q: f4(samples.q), w: f2(samples.w), a: f2(samples.a), j: f2(samples.j), exactness_deg: 0.004 });
const asBytes = {
  data: 2,
  keys: { t: f8(keys.t), q: f4(keys.q), p: [] },
  methods: [method('a', typed(turned(1), u4(times, 0, 0.05 / 1000))), method('b', typed(turned(0.5), { like: 0 }))],
};
const said = async (page) => {
  await page.locator('input[type=range]').fill('0.5');
  return page.locator('[data-quantity] figcaption').allTextContents();
};
let ofArrays;
pageOf('data in arrays are shown', JSON.stringify(asArrays), async (page) => {
  ofArrays = await said(page);
  assert.match(ofArrays[0], /a 28\.65.*b 14\.32/);
  assert.equal(await page.locator('.plots .facts').isVisible(), false); // how exact they are is not known
});
pageOf('data in bytes are shown as those in arrays are, with how exact the drawing is', JSON.stringify(asBytes), async (page) => {
  assert.deepEqual(await said(page), ofArrays);
  assert.equal(await page.locator('.plots .facts').textContent(), 'Curves are drawn within 0.01°, the angle between two within 0.02°.');
});

const coarse = { ...asBytes, methods: asBytes.methods.map((one, i) => ({ ...one, samples: { ...one.samples, exactness_deg: [0.0312, 0.001][i] } })) };
pageOf('the angle that was reached is said where it is not the wanted one', JSON.stringify(coarse), async (page) => {
  assert.equal(await page.locator('.plots .facts').textContent(), 'Curves are drawn within 0.037°, the angle between two within 0.073°.');
});

const clock = { t: [0, 1], own: [0, 0.5] };
const retimed = { ...asBytes, methods: [asBytes.methods[0], method('slower', asBytes.methods[0].samples, { clock })] };
pageOf('a method with a clock is seen at its own time, and is not compared at that of the page', JSON.stringify(retimed), async (page) => {
  assert.equal(await page.locator('[data-quantity=apart]').isVisible(), false);
  await page.locator('select.second').selectOption('');
  const picture = async (name, time) => {
    await page.locator('select.first').selectOption(name);
    await page.locator('input[type=range]').fill(time);
    await drawn(page);
    return page.locator('.sphere canvas').screenshot();
  };
  const slower = await picture('slower', '1');
  assert.match(await page.locator('[data-quantity=angle] figcaption').textContent(), /slower 57\.30/); // plots are over its own times
  assert.deepEqual(await picture('a', '0.5'), slower);
  assert.notDeepEqual(await picture('a', '1'), slower);
}, { draws: true });
