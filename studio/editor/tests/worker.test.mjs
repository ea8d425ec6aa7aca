// SPDX-License-Identifier: Apache-2.0
// The worker in a real browser, in a page from the disk under the policy of the studio's.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { library, placeOf } from '../../pages.js';
import { launch } from '../../report/tests/browser.mjs';
import { answers, example, packed, plain } from './engine.mjs';

const policy = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data:; worker-src blob:";
const lib = { entry: placeOf('editor/src/engine/start.ts'), formats: ['iife'], name: 'engine' };
const [{ output: [{ code }] }] = await build({ configFile: false, logLevel: 'error', resolve: { alias: [library] }, build: { write: false, target: 'es2022', lib } });

const folder = mkdtempSync(join(tmpdir(), 'orispline-worker-')), browser = await launch();
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** A page with this library within it, and all that it asks for. */
async function pageWith(text, before = '') {
  const path = join(folder, 'page.html'), script = (content) => `<script>${content.replaceAll('</script', '<\\/script')}</script>`;
  writeFileSync(path, `<!doctype html><meta charset="utf-8" /><meta http-equiv="Content-Security-Policy" content="${policy}" />
<script id="studio-module" type="text/plain">${text}</script>${script(before)}${script(code)}${script('globalThis.studio = engine.startEngine();')}`);
  const page = await browser.newPage(), requests = [], faults = [];
  page.on('request', (request) => requests.push(request.url().replace(/:.*/s, '')));
  page.on('pageerror', (error) => faults.push(error.message));
  await page.goto(String(pathToFileURL(path)));
  return { page, requests, faults };
}

test('it answers in a page from the disk, which asks for nothing', async () => {
  const { page, requests, faults } = await pageWith(packed), bytes = readFileSync(example('five_keys.csv'));
  const told = await page.evaluate(async (content) => {
    const opened = await studio.ask('open', { bytes: Uint8Array.from(content), name: 'keys.csv' }), { document } = opened;
    const curves = [], all = new Promise((resolve) => studio.onCurves((found) => curves.push(found) === 2 && resolve()));
    studio.draw(document);
    studio.draw({ ...document, first: { method: 'bezier', settings: {} } });
    await all;
    const numbers = Object.fromEntries(Object.entries(curves[0].first).map(([name, list]) => [name, [...list]]));
    return { opened, numbers, trouble: curves[1].first.trouble.message, isSame: curves[0].second === curves[1].second };
  }, [...bytes]);
  const ask = answers(), opened = ask.open({ bytes, name: 'keys.csv' });
  assert.deepEqual(told.opened, opened);
  assert.deepEqual(told.numbers, plain(ask.curves({ document: opened.document, count: 600 }).first));
  assert.match(told.trouble, /^bezier needs/);
  assert.ok(told.isSame);
  assert.deepEqual([requests, faults], [['file', 'blob'], []]);
});

for (const [name, text, before, sentence] of [
  ['a library that is none', 'AAAA', '', /the page is not whole/],
  ['a browser without workers', packed, 'globalThis.Worker = undefined;', /gives the page no worker/],
])
  test(`${name} is told in a sentence`, async () => {
    const { page } = await pageWith(text, before);
    assert.match(await page.evaluate(() => studio.ask('methods', null).then(String, ({ message }) => message)), sentence);
  });
