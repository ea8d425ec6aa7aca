// SPDX-License-Identifier: Apache-2.0
// Views that are given other data, in a browser: as often as a key is dragged.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, launch, open } from '../../report/tests/browser.mjs';
import { partsBuilt } from './built.mjs';

const parts = `
export { Store } from 'orispline-viewer/store/store';
export { reportOf } from 'orispline-viewer/data/report';
export { playbackOf, methodMenus } from 'orispline-viewer/controls/playback';
export { showPlots } from 'orispline-viewer/plots/plots';
export { methodQuantities } from 'orispline-viewer/quantities/methods';
export { scenesOf } from 'orispline-viewer/scene/scenes';
import 'orispline-viewer/viewer';
`;

/** Runs in the page: a report of two methods that turn so far about z in so many seconds, and views of it. */
function prepare() {
  globalThis.reportWith = (angle, { end = 2, first = 'A one', second = 'B two', count = 60 } = {}) => {
    const t = Float64Array.from({ length: count }, (_, i) => (end * i) / (count - 1));
    const none = new Float64Array();
    const method = (name, part) => {
      const turn = (time) => (part * angle * time) / end / 2;
      const q = new Float64Array([...t].flatMap((time) => [Math.cos(turn(time)), 0, 0, Math.sin(turn(time))]));
      const rates = new Float64Array([...t].flatMap(() => [0, 0, (part * angle) / end]));
      const samples = { t, q, w: rates, a: new Float64Array(3 * count), j: new Float64Array(3 * count), torque: none, p: none, error_t: none, error_deg: none, straight: false, exactness_deg: null };
      const keys = { t: Float64Array.of(0, end), q: Float64Array.of(...q.subarray(0, 4), ...q.subarray(-4)), p: none };
      return { name, continuity: '', failure: '', measures: {}, samples, keys, bands: {}, clock: null };
    };
    const methods = [method(first, 1), method(second, 0.5)];
    return orispline.reportOf({ first, second, methods, keys: methods[0].keys });
  };
  globalThis.show = (report) => {
    const store = new orispline.Store(report);
    const place = Object.assign(document.createElement('div'), { className: 'orispline-viewer' });
    document.querySelector('main').append(place);
    place.append(...orispline.playbackOf(store, orispline.methodMenus(store), place), ...orispline.scenesOf(store));
    const plots = Object.assign(document.createElement('div'), { className: 'plots' });
    place.append(plots);
    const plotted = orispline.showPlots(store, plots, orispline.methodQuantities(store), ['first', 'second', 'components']);
    return Object.assign(globalThis, { store, plotted });
  };
  globalThis.buffers = 0;
  const all = WebGL2RenderingContext.prototype;
  for (const [name, change] of [['createBuffer', 1], ['deleteBuffer', -1]]) {
    const call = all[name];
    all[name] = function (...values) {
      globalThis.buffers += change;
      return call.apply(this, values);
    };
  }
}

const folder = mkdtempSync(join(tmpdir(), 'orispline-replace-'));
const file = join(folder, 'page.html');
let browser;
before(async () => {
  const { script, style } = await partsBuilt(parts);
  writeFileSync(file, `<!doctype html><html lang="en"><head><meta charset="utf-8"><link rel="icon" href="data:,"><title>Page</title><style>${style}</style></head><body><main></main><script>${script.replaceAll('</script', '<\\/script')}</script></body></html>`);
  browser = await launch();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const onPage = (name, steps, options = {}) =>
  test(name, async () => {
    const page = await open(browser, file, { first: prepare, viewport: { width: 1400, height: 2400 }, ...options });
    await steps(page);
    await page.finish();
  });

const picture = (page, which) => page.locator(`.stages .${which} canvas`).evaluate((canvas) => canvas.toDataURL());

onPage('other data are shown by the views that there are', async (page) => {
  await page.evaluate(() => show(reportWith(1)));
  await page.evaluate(() => store.choose({ time: 1, axis: 'y', theme: 'dark' }));
  await drawn(page);
  const views = ['first', 'second', 'sphere'];
  const before = await Promise.all(views.map((one) => picture(page, one)));
  await page.evaluate(() => {
    globalThis.elements = [...document.querySelectorAll('canvas')];
    store.replace(reportWith(2));
  });
  await drawn(page);
  assert.equal(await page.evaluate(() => [...document.querySelectorAll('canvas')].every((one, i) => one === elements[i])), true);
  for (const [i, one] of views.entries()) assert.notEqual(await picture(page, one), before[i], one);
  const last = await page.evaluate(() => ['angle', 'w', 'apart'].map((id) => plotted(id).at(-1).values.at(-1)));
  for (const [k, wanted] of [(2 * 180) / Math.PI, 1, 180 / Math.PI].entries()) assert.ok(Math.abs(last[k] - wanted) < 1e-9, `${last}`);
  const { time, axis, theme } = await page.evaluate(() => store.current());
  assert.deepEqual([time, axis, theme], [1, 'y', 'dark']);
}, { draws: true });

/** Of each line of a plot: the value where its dot is, and the one that is written beside its name. */
const pointed = (page, id) =>
  page.evaluate((id) => {
    const figure = document.querySelector(`[data-quantity=${id}]`);
    const over = figure.querySelector('.u-over').getBoundingClientRect();
    const line = figure.querySelector('.u-cursor-x').getBoundingClientRect();
    const dots = [...figure.querySelectorAll('.now')].filter(({ hidden }) => !hidden).map((dot) => dot.getBoundingClientRect());
    const middles = dots.map(({ left, top, width, height }) => ({ x: left + width / 2 - line.left, y: (over.bottom - top - height / 2) / over.height }));
    return { middles, written: [...figure.querySelectorAll('figcaption span > b')].map(({ textContent }) => Number(textContent)) };
  }, id);

onPage('the dot of a line is where its value is, also of lines that changed while the time stays', async (page) => {
  await page.evaluate(() => show(reportWith(1)));
  await page.evaluate(() => store.choose({ time: 1, components: false }));
  await drawn(page);
  for (const angle of [1, 2, 0.5]) {
    await page.evaluate((angle) => store.replace(reportWith(angle)), angle);
    await drawn(page);
    const { middles, written } = await pointed(page, 'w');
    assert.deepEqual(written, [angle / 2, angle / 4]);
    const share = Math.min(...middles.map(({ y }) => y)) / Math.max(...middles.map(({ y }) => y));
    assert.ok(middles.length === 2 && Math.abs(share - 0.5) < 0.01 && middles.every(({ x }) => Math.abs(x) < 2), JSON.stringify(middles));
  }
});

onPage('where a line jumps, dots and values are those behind the jump, of all lines', async (page) => {
  await page.evaluate(() => {
    const report = reportWith(1, { count: 5 }); // at 0, 0.5, 1, 1.5 and 2 s
    for (const [k, { samples }] of report.methods.entries()) {
      samples.t = Float64Array.of(0, 0.5, 1, 1, 2);
      samples.w = new Float64Array([1, 1, 1, 3, 3].flatMap((rate) => [0, 0, (k + 1) * rate]));
    }
    show(report);
    store.choose({ components: true });
  });
  for (const [time, wanted] of [[1, [0, 0, 3, 3, 6]], [0.999, [0, 0, 1, 1, 2]], [1.001, [0, 0, 3, 3, 6]]]) {
    await page.evaluate((time) => store.moveTo(time), time);
    await drawn(page);
    const { middles, written } = await pointed(page, 'w');
    assert.deepEqual([...written].sort(), wanted, `${time}`);
    const unit = Math.max(...middles.map(({ y }) => y)) / Math.max(...wanted);
    assert.deepEqual(middles.map(({ y }) => Math.round(y / unit)).sort(), wanted, `${time}`);
  }
});

onPage('time and window stay in what there is, and the whole stays the whole', async (page) => {
  await page.evaluate(() => show(reportWith(1)));
  const after = (changes, end) =>
    page.evaluate(([changes, end]) => {
      store.choose(changes);
      store.replace(reportWith(1, { end }));
      const { time, window, extent } = store.current();
      return { time, window, extent };
    }, [changes, end]);
  assert.deepEqual(await after({ time: 2 }, 3), { time: 2, window: [0, 3], extent: [0, 3] });
  assert.deepEqual(await after({ window: [1, 2.5] }, 2), { time: 2, window: [1, 2], extent: [0, 2] });
  assert.deepEqual(await after({ window: [1.5, 2] }, 1), { time: 1, window: [0, 1], extent: [0, 1] });
  assert.equal(await page.locator('.time input').getAttribute('max'), '1');
  assert.equal(await page.locator('.time output').textContent(), '1.000 s');
});

onPage('a method that is newly named is chosen, and what was chosen stays', async (page) => {
  await page.evaluate(() => show(reportWith(1)));
  const after = (names) =>
    page.evaluate((names) => {
      store.replace(reportWith(1, names));
      const { first, second } = store.current();
      return [first, second, ...[...document.querySelectorAll('select.first option')].map(({ value }) => value)];
    }, names);
  assert.deepEqual(await after({ first: 'A three' }), ['A three', 'B two', 'A three', 'B two']);
  await page.evaluate(() => store.choose({ second: null }));
  assert.deepEqual(await after({ first: 'A three' }), ['A three', null, 'A three', 'B two']);
  assert.deepEqual(await after({ first: 'A three', second: 'B four' }), ['A three', 'B four', 'A three', 'B four']);
});

onPage('what was drawn before is freed, also by the graphics', async (page) => {
  await page.evaluate(() => show(reportWith(1)));
  await drawn(page);
  const replaced = (count) =>
    page.evaluate(async (count) => {
      const references = [];
      for (let i = 0; i < count; ++i) {
        const report = reportWith(1 + i / 10);
        references.push(...report.methods.map(({ samples }) => new WeakRef(samples)));
        store.replace(report);
        await new Promise(requestAnimationFrame);
      }
      globalThis.references = references;
      return buffers;
    }, count);
  const one = await replaced(30);
  assert.equal(await replaced(30), one);
  await drawn(page);
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  assert.ok((await page.evaluate(() => references.filter((one) => one.deref()).length)) <= 2);
}, { draws: true });
