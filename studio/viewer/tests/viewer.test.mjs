// SPDX-License-Identifier: Apache-2.0
// Viewers in a page of somebody else, in a browser.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, faultsOf, launch, open } from '../../report/tests/browser.mjs';
import { viewerBuilt } from './built.mjs';

const folder = mkdtempSync(join(tmpdir(), 'orispline-viewer-'));
const file = join(folder, 'page.html');
let browser;
before(async () => {
  const { script, style } = await viewerBuilt();
  const body = '<main><h1>Mine</h1><p id="own">text <button>b</button></p><section id="left"></section><section id="right"></section></main>';
  const scripts = script.replaceAll('</script', '<\\/script');
  writeFileSync(file, `<!doctype html><html lang="en"><head><meta charset="utf-8"><link rel="icon" href="data:,"><title>Page</title><style>${style}</style></head><body>${body}<script>${scripts}</script></body></html>`);
  browser = await launch();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** What a viewer shows, as the library writes it. */
function documentOf(names) {
  const samples = { t: [0, 1], q: [1, 0, 0, 0, 0.8, 0, 0, 0.6], w: [0, 0, 1, 0, 0, 1], a: [0, 0, 0, 0, 0, 0], j: [0, 0, 0, 0, 0, 0], torque: [], p: [], error_t: [], error_deg: [] };
  const methods = names.map((name) => ({ name, continuity: 'C0', failure: '', measures: { cost: 1 }, samples, keys: null }));
  const columns = [{ id: 'cost', label: 'Cost', unit: '', explanation: '', better: 'less', is_time: false, rounding: 0 }];
  return { methods, columns, keys: { t: samples.t, q: samples.q, p: [] } };
}

/** Puts a viewer into an element; runs in the page. */
function show(id, shown) {
  globalThis[id] = orispline.createViewer(document.getElementById(id), orispline.readDocument(shown));
}

const onPage = (name, steps, options = {}) =>
  test(name, async () => {
    const page = await open(browser, file, options);
    await page.evaluate(show.toString());
    const put = (id, ...names) => page.evaluate(`(${show})(${JSON.stringify(id)}, ${JSON.stringify(documentOf(names))})`);
    await steps(page, put);
    await page.finish();
  });

onPage('two viewers on a page know nothing of each other', async (page, put) => {
  await put('left', 'a', 'b');
  await put('right', 'c', 'd');
  await drawn(page);
  await page.evaluate(() => left.choose({ time: 0.25, theme: 'dark' }));
  assert.deepEqual(await page.locator('output').allTextContents(), ['0.250 s', '0.000 s']);
  assert.deepEqual(await page.locator('.orispline-viewer').evaluateAll((all) => all.map(({ dataset }) => dataset.theme)), ['dark', 'light']);
  await page.locator('#right tr[data-method=d] th').click();
  assert.deepEqual(await page.evaluate(() => [left.current().first, right.current().first]), ['a', 'd']);
  await page.keyboard.press('Space');
  assert.deepEqual(await page.evaluate(() => [left.current().playing, right.current().playing]), [false, true]);
  assert.deepEqual(await page.locator('[id]').evaluateAll((all) => all.map(({ id }) => id)), ['own', 'left', 'right']);
});

onPage('the lines of the README do what they say', async (page) => {
  const [, imports, lines] = /```ts\n(import .*?;)\n(.*?)```/s.exec(readFileSync(join(import.meta.dirname, '../README.md'), 'utf8'));
  const given = `const element = document.getElementById('left'), text = ${JSON.stringify(JSON.stringify(documentOf(['auto', 'slerp'])))};`;
  await page.evaluate(`{ ${imports.replace(/import (.*) from .*;/, 'const $1 = orispline;')} ${given}\n${lines} }`);
  assert.equal(await page.locator('#left').innerHTML(), '');
});

onPage('a viewer tells what is chosen until it is asked no more', async (page, put) => {
  await put('left', 'a', 'b');
  const heard = await page.evaluate(() => {
    const times = [];
    const end = left.subscribe(['time'], ({ time }) => times.push(time));
    left.choose({ time: 0.5 });
    left.choose({ first: 'b' });
    end();
    left.choose({ time: 0.75 });
    return times;
  });
  assert.deepEqual(heard, [0, 0.5]);
});

onPage('the bar at the foot of a viewer does not cover its head, where only that is in view', async (page, put) => {
  await put('left', 'a', 'b');
  await page.evaluate(() => {
    document.querySelector('h1').style.height = '700px'; // of the page, above the viewer
    scrollTo(0, 0);
  });
  await drawn(page);
  const [head, bar] = await page.evaluate(() => ['.head', '.playback'].map((one) => document.querySelector(one).getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })));
  assert.ok(head.top < 800 && bar.top >= head.bottom, `${JSON.stringify([head, bar])}`);
}, { viewport: { width: 1400, height: 800 } });

/** What the page looks like where there is no viewer. */
const looks = (page) =>
  page.evaluate(() => ['body', 'h1', '#own', '#own button'].map((one) => ['margin', 'font', 'color', 'backgroundColor', 'cursor'].map((name) => getComputedStyle(document.querySelector(one))[name])));

onPage('a viewer changes nothing outside of its element, and leaves that as it was', async (page, put) => {
  await page.locator('style').evaluate((style) => (style.disabled = true));
  const plain = await looks(page);
  await page.locator('style').first().evaluate((style) => (style.disabled = false));
  const before = await page.locator('main').innerHTML();
  await put('left', 'a', 'b');
  await drawn(page);
  assert.deepEqual(await looks(page), plain);
  await page.evaluate(() => left.choose({ playing: true }));
  await page.evaluate(() => left.destroy());
  await drawn(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  assert.equal(await page.locator('main').innerHTML(), before);
});

onPage('viewers may come and go more often than a browser has contexts', async (page, put) => {
  for (let i = 0; i < 20; ++i) {
    await put('left', 'a', 'b');
    await drawn(page);
    await page.evaluate(() => left.destroy());
  }
  await put('left', 'a', 'b');
  await drawn(page);
  const pictures = await page.locator('.stages canvas').evaluateAll((all) => all.map((canvas) => pixelsOf(canvas).data.some((value) => value > 0)));
  assert.deepEqual(pictures, [true, true, true]);
  assert.equal(await page.locator('.stages .lost:visible').count(), 0);
}, { draws: true });

onPage('two viewers are accessible', async (page, put) => {
  await put('left', 'a', 'b');
  await put('right', 'c', 'd');
  await drawn(page);
  assert.deepEqual(await faultsOf(page), []);
}, { viewport: { width: 1400, height: 3000 } }); // all of both, for a bar stays in view and may cover what is not
