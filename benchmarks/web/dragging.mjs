// SPDX-License-Identifier: Apache-2.0
// What the studio's page does while a key is dragged on its sphere, beside plots alone that are given the same curves.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { answers } from '../../studio/editor/tests/engine.mjs';
import { launch, open } from '../../studio/report/tests/browser.mjs';
import { partsBuilt } from '../../studio/viewer/tests/built.mjs';
import { keysOf } from './keys.mjs';
import { median } from './turns.mjs';

const keyCount = 40, key = keyCount / 2, count = 600, method = 'auto', beside = 'timed-c2', rounds = 9, steps = 10, circle = 24; // [px] radius of the drag
const viewport = { width: 1440, height: 900 };

const marker = '__ORISPLINE_STUDIO_DATA__';

const withKeys = (page, { times, orientations }) => {
  const rows = Array.from(times, (t, k) => [t, ...orientations.subarray(4 * k, 4 * k + 4)].join());
  const content = Buffer.from(`t,qw,qx,qy,qz\n${rows.join('\n')}\n`).toString('base64');
  if (!page.includes(marker)) throw new Error('found a page with keys in it, wanted that which make studio builds');
  return page.replace(marker, () => JSON.stringify({ studio: 1, version: '0.2.0', name: 'keys.csv', content, method, beside }));
};

/** Runs in a page before all else: notes what its worker is asked to draw and what has come, and how long scripts wait for the graphics [s]. */
function watch() {
  const seen = (globalThis.seen = { documents: [], answered: 0, waited: 0 });
  const post = Worker.prototype.postMessage, numbers = new WeakMap();
  Worker.prototype.postMessage = function (asked, ...more) {
    if (!numbers.has(this)) {
      numbers.set(this, new Set());
      this.addEventListener('message', ({ data }) => numbers.get(this).has(data.number) && ++seen.answered);
    }
    if (asked.name === 'curves') {
      numbers.get(this).add(asked.number);
      seen.documents.push(asked.given.document);
    }
    return post.call(this, asked, ...more);
  };
  const hand = OffscreenCanvas.prototype.transferToImageBitmap;
  OffscreenCanvas.prototype.transferToImageBitmap = function () {
    const start = performance.now();
    try {
      return hand.call(this);
    } finally {
      seen.waited += (performance.now() - start) / 1e3;
    }
  };
  globalThis.settled = async () => {
    const frame = () => new Promise(requestAnimationFrame);
    do await frame();
    while (seen.answered < seen.documents.length);
    for (let k = 0; k < 3 || document.querySelector('[aria-busy]'); ++k) await frame();
  };
}

const parts = `
import '../../editor/src/style/viewer.css';
import '../../editor/src/style/studio.css';
export { Store } from 'orispline-viewer/store/store';
export { element } from 'orispline-viewer/look/element';
export { coloursOf, paint } from 'orispline-viewer/look/theme';
export { showPlots } from 'orispline-viewer/plots/plots';
export { methodQuantities } from 'orispline-viewer/quantities/methods';
export { Shown } from '../../editor/src/store/shown';
`;

/** Runs in a page of these parts: the plots of the studio, as large as there. `give` has the reports made; `next` shows one more. */
function showPlotsAlone(first, ids, { width, height }) {
  const { Store, Shown, element, coloursOf, paint, showPlots, methodQuantities } = orispline, shown = new Shown();
  const typed = (drawn) => Object.fromEntries(Object.entries(drawn).map(([name, list]) => [name, Float64Array.from(list)]));
  const reportOf = ({ document, curves }) => shown.report(document, { first: typed(curves.first), second: typed(curves.second) });
  const view = new Store(reportOf(first)), root = element('div', { className: 'orispline-viewer orispline-studio' }), plots = element('div', { className: 'plots' });
  view.choose({ components: false });
  paint(root, coloursOf(view.current()));
  plots.style.cssText = `width: ${width}px; height: ${height}px`;
  root.append(plots);
  document.body.append(root);
  showPlots(view, plots, methodQuantities(view).filter(({ id }) => ids.includes(id)), ['first', 'second', 'components']);
  let reports = [];
  globalThis.give = (drawn) => (reports = drawn.map(reportOf));
  globalThis.next = () => view.replace(reports.shift());
}

/** The processor time of a page's scripts [s], by the browser's own account, and how long they waited for the graphics. */
const accountOf = async (page) => {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return { script: metrics.find(({ name }) => name === 'ScriptDuration').value, waited: await page.evaluate(() => seen.waited) };
  };
};

/** Of one step of some. */
const spent = async (account, work) => {
  const before = await account();
  for (let step = 0; step < steps; ++step) await work(step);
  const after = await account();
  return { script: (after.script - before.script) / steps, waited: (after.waited - before.waited) / steps };
};

/** Takes the key by its handle; gives what drags it one step further, round and round. */
const dragOf = async (page) => {
  const { x, y } = await page.getByRole('group', { name: 'Sphere' }).evaluate((sphere, key) => {
    const all = [...sphere.querySelectorAll('.handle')], circle = all.slice(key).find((one) => !one.classList.contains('behind')), { left, top } = circle.ownerSVGElement.getBoundingClientRect();
    return { x: left + Number(circle.getAttribute('cx')), y: top + Number(circle.getAttribute('cy')) };
  }, key);
  await page.mouse.move(x, y);
  await page.mouse.down();
  let angle = 0;
  return async () => {
    angle += 0.3;
    await page.mouse.move(x + circle * Math.sin(angle), y + circle * (1 - Math.cos(angle)));
    await page.evaluate(() => settled());
  };
};

const plotsPage = async () => {
  const { script, style } = await partsBuilt(parts);
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><link rel="icon" href="data:,"><title>Plots</title><style>${style}</style></head><body><script>${script.replaceAll('</script', '<\\/script')}</script></body></html>`;
};

/** The drawing of a document, as plain data. */
const drawnOf = (curves) => (document) => {
  const { first, second } = curves({ document, count }), plain = (drawn) => Object.fromEntries(Object.entries(drawn).map(([name, list]) => [name, [...list]]));
  return { document, curves: { first: plain(first), second: plain(second) } };
};

const measured = async (browser, folder, file) => {
  const whole = await open(browser, file('whole.html', withKeys), { viewport, first: watch });
  await whole.locator('.plots canvas').last().waitFor();
  await whole.evaluate(() => settled());
  const drag = await dragOf(whole), drawn = drawnOf(answers().curves), documents = () => whole.evaluate(() => seen.documents.splice(0, (seen.answered = 0) || seen.documents.length));
  const [first] = await documents(), size = await whole.getByRole('group', { name: 'Plots' }).boundingBox();
  const plots = await open(browser, join(folder, 'plots.html'), { viewport, first: watch });
  await plots.evaluate(`(${showPlotsAlone})(${JSON.stringify(drawn(first))}, ['w', 'a', 'j', 'apart'], ${JSON.stringify(size)})`);
  const [accountOfWhole, accountOfPlots] = [await accountOf(whole), await accountOf(plots)], found = [];
  for (let round = 0; round <= rounds; ++round) {
    const ours = await spent(accountOfWhole, drag), dragged = await documents();
    if (dragged.length !== steps) throw new Error(`found ${dragged.length} documents drawn, wanted one for each of ${steps} steps`);
    await plots.evaluate((all) => void give(all), dragged.map(drawn));
    const theirs = await spent(accountOfPlots, () => plots.evaluate(() => (next(), settled())));
    found.push({ whole: ours.script, waited: ours.waited, plots: theirs.script });
  }
  return found.slice(1); // the first one was for the compiler
};

/** `page`: the studio's, as it is built. The browser's version, and the ratios. */
export const draggingRatios = async (page) => {
  const folder = mkdtempSync(join(tmpdir(), 'orispline-')), browser = await launch(), content = readFileSync(page, 'utf8'), keys = keysOf(keyCount, 1);
  try {
    writeFileSync(join(folder, 'plots.html'), await plotsPage());
    const file = (name, change) => (writeFileSync(join(folder, name), change(content, keys)), join(folder, name));
    const found = await measured(browser, folder, file), of = (ratio) => median(found.map(ratio));
    const ratios = [
      { what: `the studio's page for one step of a key of ${keyCount} that is dragged, \`${method}\` and \`${beside}\` with ${count} samples each, beside the plots alone`, ratio: of(({ whole, plots }) => whole / plots), most: 3 },
      { what: '… with what it waits for software that stands in for graphics', ratio: of(({ whole, waited, plots }) => (whole + waited) / plots) },
    ];
    return { version: browser.version(), ratios };
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
};
