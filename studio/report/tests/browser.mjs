// SPDX-License-Identifier: Apache-2.0
// A real browser without a screen, and pages in it that must not complain.
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

export const executable = process.env.CHROMIUM ?? '/usr/bin/chromium';

const quiet = ['--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-quic', '--no-first-run'];
const software = ['--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export const launch = (...more) => chromium.launch({ executablePath: executable, args: ['--no-sandbox', ...quiet, ...software, ...more] });

/** Opens a file; the page's complaints and what it asks of the network are collected in it. */
export async function open(browser, file, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1400, height: 1000 }, ...options });
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
