// SPDX-License-Identifier: Apache-2.0
// The pictures of docs/studio.md: node editor/tests/pictures.mjs PAGE FOLDER, such as ../build/studio/studio.html ../docs
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { drawn, launch, open } from '../../report/tests/browser.mjs';
import { paletted } from '../../tests/palette.mjs';

const [file, folder] = process.argv.slice(2);
const desktop = { viewport: { width: 1400, height: 860 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** Until nothing has been drawn anew for some frames: curves come from a worker. */
async function settled(page) {
  for (let before; ; ) {
    await drawn(page);
    const now = (await page.screenshot()).toString('base64');
    if (now === before) return;
    before = now;
  }
}

/** Not for the first time. */
const known = () => localStorage.setItem('orispline-studio-toured', '1');
const more = (page) => page.getByRole('button', { name: 'More' }).click();

/** The five keys of the paper beside squad; the third is chosen, and its tension pulled up. */
async function fiveKeys(page) {
  await page.getByRole('button', { name: 'Tensions of a paper' }).click();
  await page.getByRole('heading', { name: 'five_tensions.csv' }).waitFor();
  await page.getByRole('combobox', { name: 'Compare with', exact: true }).selectOption('squad');
  await page.getByRole('slider', { name: 'tension of key 3' }).focus();
  for (let i = 0; i < 20; i++) await page.keyboard.press('ArrowUp');
  await page.evaluate(() => document.activeElement.blur());
}

async function take(name, options, prepare, begin = fiveKeys) {
  const page = await open(browser, file, { ...options, draws: true, first: known });
  await begin(page);
  await prepare(page);
  await settled(page);
  writeFileSync(join(folder, name), paletted(await page.screenshot()));
  await page.close();
}

const browser = await launch();
await take('studio-motion.png', desktop, async () => {}, async (page) => {
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.evaluate(() => studio.current.studio.view.moveTo(2.45));
  await page.evaluate(() => document.activeElement.blur());
});
await take('studio.png', desktop, async (page) => {
  await more(page);
  await page.getByRole('combobox', { name: 'Shape' }).selectOption('aircraft');
  await more(page);
  await page.evaluate(() => document.activeElement.blur());
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight'); // both curves are apart between keys
});
await take('studio-table.png', { ...desktop, colorScheme: 'dark' }, async (page) => {
  await more(page);
  await page.getByRole('button', { name: 'Table' }).click();
  await page.getByRole('textbox', { name: 'Z, first turn of key 4' }).focus();
});
await take('studio-phone.png', phone, (page) => page.getByRole('group', { name: 'Sphere' }).evaluate((sphere) => sphere.scrollIntoView()));
await browser.close();
