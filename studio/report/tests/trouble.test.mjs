// SPDX-License-Identifier: Apache-2.0
// Reports of odd data, on paper and on a narrow screen.
import assert from 'node:assert/strict';
import { drawn, faultsOf, tooWide } from './browser.mjs';
import { column, keysAt, method, reports, spread, turning } from './made.mjs';

const reportWith = reports();
const times = spread(21, 10);
const keys = keysAt([0, 10], 0.1);
const caption = (page, id) => page.locator(`[data-quantity=${id}] figcaption`).textContent();
const many = Array.from({ length: 30 }, (_, i) => method(`method ${i}`, turning(times, 0.1 + i / 100), { measures: Object.fromEntries(Array.from({ length: 26 }, (_, k) => [`measure${k}`, i + k / 7])) }));
const large = { title: 'T', command: 'orispline compare keys.csv', notes: ['One.', 'Two.', 'Three.'], keys, columns: Array.from({ length: 26 }, (_, k) => column(`measure${k}`, { label: `largest ${k}` })), methods: many };

const holed = turning(times, 0.1);
const without = (list, from, to) => list.map((value, i) => (i >= from && i < to ? null : value));
for (const [name, q] of [['with rates that are not finite', holed.q], ['with rates and an orientation that are not', without(holed.q, 41, 42)]])
  reportWith(`samples ${name} leave a hole`, { keys, methods: [method('a', { ...holed, q, w: without(holed.w, 30, 33), a: without(holed.a, 30, 33), j: without(holed.j, 30, 33) })] }, async (page) => {
    await page.evaluate(() => viewer.choose({ time: 5 }));
    await drawn(page);
    assert.match(await caption(page, 'w'), /a –/);
    await page.evaluate(() => viewer.choose({ time: 1 }));
    assert.match(await caption(page, 'w'), /a 0\.1000/);
    assert.match(await caption(page, 'angle'), /a 5\.730/);
  });

const jump = turning([0, 4, 4, 10], 0.1, { q: [0, 0.4, 1.4, 2].flatMap((angle) => [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)]) });
reportWith('two equal times are a jump, after which the right side is shown', { keys: keysAt([0, 4, 4, 10], 0.1), methods: [method('a', jump), method('b', turning(times, 0.1))] }, async (page) => {
  await page.evaluate(() => viewer.choose({ time: 4 }));
  assert.match(await caption(page, 'angle'), /a 80\.21/);
  assert.match(await caption(page, 'apart'), /57\.30/);
});

const hostile = '<img src=x onerror="window.pwned=1"></script><b>bold</b>';
const named = { title: hostile, notes: [hostile], warnings: [hostile], command: hostile, keys, columns: [column('cost', { label: hostile, explanation: hostile })], methods: [method(hostile, turning(times, 0.1)), method('b', turning(times, 0.2))] };
reportWith('markup in names is text', named, async (page) => {
  assert.equal(await page.locator('main img, main b:has-text("bold")').count(), 0);
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  assert.equal(await page.locator('h1').textContent(), hostile);
  assert.equal(await page.locator('tbody th').first().textContent(), hostile);
  assert.ok((await caption(page, 'w')).includes(hostile));
  assert.ok((await page.locator('select.first option').allTextContents()).includes(hostile));
});

reportWith('on paper there is no bar, and tables and plots are whole', large, async (page) => {
  await page.setViewportSize({ width: 1032, height: 700 }); // A4 across, without its margins
  await page.emulateMedia({ media: 'print' });
  await drawn(page);
  assert.equal(await page.locator('.playback, .plots .controls, .theme').evaluateAll((all) => all.filter((one) => one.offsetHeight > 0).length), 0);
  const measures = await page.locator('.measures').evaluate((one) => [one.scrollHeight - one.clientHeight, one.scrollWidth - one.clientWidth]);
  assert.deepEqual(measures, [0, 0]);
  const cut = await page.locator('.plots canvas').evaluateAll((all) => all.filter((one) => one.getBoundingClientRect().right > one.closest('figure').getBoundingClientRect().right || one.offsetHeight === 0).length);
  assert.equal(cut, 0);
  const shifted = await page.locator('.stages .frame:visible').evaluateAll((all) =>
    all.filter((frame) => {
      const [picture, names] = ['canvas', 'svg'].map((part) => frame.querySelector(part).getBoundingClientRect());
      return ['x', 'y', 'width', 'height'].some((side) => Math.abs(picture[side] - names[side]) > 1);
    }).length,
  );
  assert.equal(shifted, 0); // names stand where they are in the picture
  assert.equal(await page.getByText('Three.').isVisible(), true);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 1032);
  const [, width, height] = /MediaBox ?\[0 0 ([\d.]+) ([\d.]+)\]/.exec((await page.pdf({ preferCSSPageSize: true })).toString('latin1')).map(Number);
  assert.ok(width > height, `${width} by ${height}`); // so many columns have no room on paper that is upright
});

reportWith('what is printed is light, and the page is dark again', large, async (page) => {
  const theme = () => page.evaluate(() => viewer.current().theme);
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  assert.equal(await theme(), 'light');
  assert.equal(await page.locator('[aria-busy]').count(), 0);
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.equal(await theme(), 'dark');
}, { colorScheme: 'dark' });

reportWith('a screen of 320 px shows all', large, async (page) => {
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
  assert.deepEqual(await tooWide(page), []);
  assert.deepEqual(await faultsOf(page), []);
}, { viewport: { width: 320, height: 640 }, isMobile: true, hasTouch: true });
