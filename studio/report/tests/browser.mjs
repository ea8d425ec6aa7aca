// SPDX-License-Identifier: Apache-2.0
// A real browser without a screen, and pages in it that must not complain.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

export const executable = process.env.CHROMIUM ?? '/usr/bin/chromium';

/** Whether tests run on every screen and draw every scene: at night. */
const isThorough = Boolean(process.env.ORISPLINE_THOROUGH);

const quiet = ['--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-quic', '--no-first-run'];
const software = ['--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export const launch = (...more) => chromium.launch({ executablePath: executable, args: ['--no-sandbox', ...quiet, ...software, ...more] });

const checker = readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');
const rules = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

/** What the checker of accessibility finds, one line each. */
export async function faultsOf(page) {
  await page.evaluate(checker);
  const { violations } = await page.evaluate((values) => axe.run(document, { preload: false, runOnly: { type: 'tag', values } }), rules);
  return violations.map(({ impact, id, nodes }) => `${impact}: ${id}: ${nodes.length} such as ${nodes[0].html.slice(0, 120)}`);
}

/** Elements that stand out at the right; in a box that is scrolled by itself they may. */
export const tooWide = (page) =>
  page.locator('body *:visible').evaluateAll((all) =>
    all.filter((one) => !one.closest('.measures table, .joints table, .rows table, pre code') && one.getBoundingClientRect().right > innerWidth + 1).map((one) => one.outerHTML.slice(0, 80)),
  );

export const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const sizes = { 'on a wide screen': {}, 'on a tablet': { viewport: { width: 820, height: 1180 }, hasTouch: true }, 'on a phone': phone };

const everyScreen = Object.entries(sizes).flatMap(([name, options]) => [[name, options], [`${name} in the dark`, { ...options, colorScheme: 'dark' }]]);
const mostDifferent = ['on a wide screen', 'on a phone in the dark'];

/** Those that a page is looked at on: the two that differ most, and all of them in a thorough test. */
export const screens = Object.fromEntries(isThorough ? everyScreen : everyScreen.filter(([name]) => mostDifferent.includes(name)));

/** Waits for frames instead of time: one for the sizes, one for what is drawn in them, one for what that changes; and for plots out of view. */
export const drawn = (page) =>
  page.evaluate(async () => {
    for (let frame = 0; frame < 3 || document.querySelector('[aria-busy]'); ++frame) await new Promise(requestAnimationFrame);
  });

/** What a canvas shows, in a page, whoever draws it. */
function withPixels() {
  window.pixelsOf = (canvas) => {
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    return context.getImageData(0, 0, copy.width, copy.height);
  };
}

/** To run before a page: a browser that has no graphics. */
export function withoutGraphics() {
  const own = OffscreenCanvas.prototype.getContext;
  OffscreenCanvas.prototype.getContext = function (kind, ...more) {
    return kind.startsWith('webgl') ? null : own.call(this, kind, ...more);
  };
}

/** Scenes are as they would be, but their shapes are not drawn, which takes long without a graphics card. */
function withoutShapes() {
  for (const draw of ['drawArrays', 'drawArraysInstanced', 'drawElements', 'drawElementsInstanced', 'drawRangeElements']) WebGL2RenderingContext.prototype[draw] = () => {};
}

/** To run before a page whose scenes no test looks at; thorough tests draw them all the same. */
export const unseen = isThorough ? () => {} : withoutShapes;

/**
 * Opens a file; the page's complaints and what it asks of the network are collected in it. `first` runs in it before all else. Its scenes
 * are drawn where the test `draws`.
 */
export async function open(browser, file, { first, draws = false, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1400, height: 1000 }, ...options });
  page.setDefaultTimeout(120_000); // other work may be beside it
  await page.addInitScript(withPixels);
  if (!draws) await page.addInitScript(unseen);
  if (first) await page.addInitScript(first);
  const complaints = [];
  const requests = [];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  const url = pathToFileURL(file).href;
  await page.goto(url);
  const close = async () => {
    await page.close();
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests, [url]);
  };
  return Object.assign(page, { finish: close });
}
