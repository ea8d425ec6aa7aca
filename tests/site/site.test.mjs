// SPDX-License-Identifier: Apache-2.0
// The site from the disk: on a wide and on a narrow screen, in light and dark, by keyboard, and its search.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { faultsOf, launch } from './browser.mjs';

const sizes = { 'on a wide screen': { width: 1400, height: 900 }, 'at 320 px': { width: 320, height: 640 } };
const pages = { 'the first page': 'index.html', 'a page of formulas and tables': 'docs/smooth.html', 'the reference of Python': 'python/index.html', 'a search': 'search.html?q=gimbal+lock' };

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** A page of the site; `finish` closes it, and wants no complaint and nothing from elsewhere. */
async function opened(file, options = {}) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(120_000); // other work may be beside it
  const trouble = [];
  page.on('console', (message) => message.type() === 'error' && trouble.push(message.text()));
  page.on('pageerror', (error) => trouble.push(error.message));
  page.on('request', (request) => request.url().startsWith('file:') || trouble.push(request.url()));
  await page.goto(new URL(file, `${pathToFileURL(process.env.SITE)}/`).href);
  const finish = async () => {
    await page.close();
    assert.deepEqual(trouble, []);
  };
  return Object.assign(page, { finish });
}

for (const [name, file] of Object.entries(pages)) {
  for (const [size, viewport] of Object.entries(sizes)) {
    for (const colorScheme of ['light', 'dark']) {
      test(`${name} ${size} in ${colorScheme} is fit for every reader`, async () => {
        const page = await opened(file, { viewport, colorScheme });
        assert.deepEqual(await faultsOf(page), []);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= viewport.width);
        await page.finish();
      });
    }
  }
}

/** Goes on with the key Tab until the element has the focus; it is within the first twenty. */
async function tabTo(page, selector) {
  for (let presses = 0; presses < 20; ++presses) {
    await page.keyboard.press('Tab');
    if (await page.evaluate((wanted) => document.activeElement.matches(wanted), selector)) return;
  }
  assert.fail(`the key Tab does not lead to ${selector}`);
}

test('the search finds what is typed on the first page, by keyboard alone', async () => {
  const page = await opened('index.html', { viewport: sizes['on a wide screen'] });
  await tabTo(page, '.sidebar-search');
  await page.keyboard.type('gimbal lock');
  await page.keyboard.press('Enter');
  const found = page.locator('#search-results li a');
  await found.first().waitFor();
  assert.ok((await found.allTextContents()).includes('Files'));
  await found.getByText('Files', { exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.waitForURL(/docs\/files\.html/);
  await page.finish();
});

test('the side bar of a narrow screen opens by keyboard, and is out of reach before', async () => {
  const page = await opened('index.html', { viewport: sizes['at 320 px'] });
  const entry = page.locator('.sidebar-tree').getByText('Which method when', { exact: true });
  assert.ok(!(await entry.isVisible()));
  await tabTo(page, '.nav-overlay-icon');
  await page.keyboard.press('Enter');
  await entry.click();
  await page.waitForURL(/docs\/choosing\.html/);
  await page.finish();
});
