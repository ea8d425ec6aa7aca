// SPDX-License-Identifier: Apache-2.0
// The places of things on screens of desktops, with the table of keys beside them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { opener } from './opener.mjs';
import { panelPage } from './panelPage.mjs';

const row = (i) => [i, Math.cos(0.1 * i), Math.sin(0.1 * i), 0, 0];
const csv = (count, places) => [places ? 't,qw,qx,qy,qz,px,py,pz' : 't,qw,qx,qy,qz', ...Array.from({ length: count }, (_, i) => [...row(i), ...(places ? [i, 0, 0] : [])].join())].join('\n');
const opened = opener(panelPage);

const boxOf = (page, selector) => page.locator(selector).boundingBox();

for (const [width, height] of [[1400, 900], [1280, 720], [1120, 700]])
  for (const [count, places, method] of [[5, false, 'timed-c2'], [5, true, 'slerp'], [1000, true, 'timed-c2']])
    test(`with the table nothing is covered or cut on ${width} by ${height} pixels: ${count} keys${places ? ' with positions' : ''}, ${method}`, async () => {
      const page = await opened({ viewport: { width, height } });
      await page.evaluate(([text, method]) => begin(text, 'keys.csv', { method }), [csv(count, places), method]);
      await page.getByRole('button', { name: 'Table', exact: true }).click();
      const [timeline, track, plots, upper, caption] = await Promise.all(['.timeline', '.track', '.plots', '.upper', '.body > .caption'].map((selector) => boxOf(page, selector)));
      const bottom = ({ y, height }) => y + height;
      assert.ok(bottom(track) <= bottom(timeline) + 1, 'the timeline is whole');
      assert.ok(bottom(timeline) <= bottom(upper) + 1, 'the timeline is beside the table');
      assert.ok(bottom(upper) <= plots.y, 'the plots are below it');
      assert.ok(caption.height < 45, 'the menus of the body are one line');
      if (method !== 'slerp') assert.ok((await boxOf(page, '.bars')).height > 40, 'bars are seen');
      await page.finish();
    });

test('the long text of a method with settings wraps no menu of the body', async () => {
  const page = await opened({ viewport: { width: 1400, height: 900 } });
  await page.evaluate(([text]) => begin(text, 'keys.csv', { method: 'timed-c2' }), [csv(5, false)]);
  await page.evaluate(() => {
    const { store } = app.current.studio;
    const { document } = store.current();
    store.edit({ ...document, first: { method: 'timed-c2', settings: { tension: 0.123456, tension2: 1.234567, ends: 'clamped,repeat', 'start-rate': '0.1,0.2,0.3' } } });
  });
  await page.getByRole('group', { name: 'Body' }).getByText('Curve timed-c2:tension=0.123456').waitFor();
  assert.ok((await boxOf(page, '.body > .caption')).height < 45);
  const [menu, body] = await Promise.all(['.body > .caption > :last-child', '.body'].map((selector) => boxOf(page, selector)));
  assert.ok(menu.x + menu.width <= body.x + body.width);
  await page.finish();
});

test('a closed menu of methods shows a name, its list the titles', async () => {
  const page = await opened({ viewport: { width: 1400, height: 900 } });
  await page.evaluate(([text]) => begin(text, 'keys.csv', { method: 'hermite-c1' }), [csv(5, false)]);
  const menu = page.getByRole('combobox', { name: 'Curve', exact: true });
  const name = page.locator('.named.first .name');
  assert.equal(await name.textContent(), 'hermite-c1');
  assert.ok(await name.evaluate((one) => one.scrollWidth <= one.clientWidth));
  assert.equal(await menu.locator('option:checked').textContent(), 'hermite-c1 – Cubic Hermite curve through rates of the keys');
  await menu.selectOption('slerp');
  assert.equal(await name.textContent(), 'slerp');
  await page.finish();
});
