// SPDX-License-Identifier: Apache-2.0
// A picture of a report: node tests/picture.mjs PAGE PICTURE.png [METHOD BESIDE SECONDS]
import { writeFileSync } from 'node:fs';
import { paletted } from '../../tests/palette.mjs';
import { drawn, launch, open } from './browser.mjs';

const [file, picture, method, beside, seconds] = process.argv.slice(2);
const browser = await launch();
const page = await open(browser, file, { viewport: { width: 1400, height: 1690 }, draws: true });
if (method) await page.locator('label.choice', { hasText: 'Method' }).locator('select').selectOption(method);
if (beside) await page.locator('label.choice', { hasText: 'beside' }).locator('select').selectOption(beside);
if (seconds)
  await page.locator('input[type=range]').evaluate((input, time) => {
    input.value = time;
    input.dispatchEvent(new Event('input'));
  }, seconds);
await drawn(page);
writeFileSync(picture, paletted(await page.screenshot()));
await page.finish();
await browser.close();
