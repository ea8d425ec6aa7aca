// SPDX-License-Identifier: Apache-2.0
// The scenes in space: what they ask of the graphics, and what they show. The template is the one that was built.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, faultsOf, launch, open, phone, tooWide, withoutGraphics } from './browser.mjs';

const template = readFileSync(new URL('../dist/index.html', import.meta.url), 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'orispline-scenes-'));
const times = (count, step) => Array.from({ length: count }, (_, i) => i * step);
const path = (t) => t.flatMap((time) => [3 * Math.cos(time), 3 * Math.sin(time), time / 4]);
/** Turns about z, and tumbles on the way. */
const turned = (t, speed) => t.flatMap((time) => [Math.cos(speed * time) * Math.cos(time / 7), Math.sin(time / 7) * 0.6, Math.sin(time / 7) * 0.8, Math.sin(speed * time) * Math.cos(time / 7)]);
const zeros = (t) => t.flatMap(() => [0, 0, 0]);
const samplesAt = (t, speed, more) => ({ t, q: turned(t, speed), w: [], a: zeros(t), j: zeros(t), torque: [], p: path(t), error_t: [], error_deg: [], ...more });
const method = (name, t, speed, more) => ({ name, continuity: 'C0', failure: '', measures: {}, samples: samplesAt(t, speed, more), keys: null });
const [keyTimes, sampleTimes] = [times(601, 0.05), times(1201, 0.025)];
const many = {
  title: 'T',
  body: 'box',
  keys: { t: keyTimes, q: turned(keyTimes, 0.5), p: path(keyTimes) },
  methods: ['a', 'b', 'c'].map((name, i) => method(name, sampleTimes, 0.5 + i / 50)),
};
const inPlace = (changes) => ({ ...many, keys: { ...many.keys, p: [] }, methods: many.methods.map((one) => ({ ...one, samples: { ...one.samples, p: [] } })), ...changes });

/** Counts what is asked of the graphics. */
function counting() {
  window.graphics = { contexts: [], linkProgram: 0, createBuffer: 0, draws: [] };
  const own = OffscreenCanvas.prototype.getContext;
  OffscreenCanvas.prototype.getContext = function (kind, ...more) {
    const context = own.call(this, kind, ...more);
    if (kind === 'webgl2' && context && !graphics.contexts.includes(context)) graphics.contexts.push(context);
    return context;
  };
  const all = WebGL2RenderingContext.prototype;
  const watch = (name, told) => {
    const call = all[name];
    all[name] = function (...values) {
      told(values);
      return call.apply(this, values);
    };
  };
  for (const name of ['linkProgram', 'createBuffer']) watch(name, () => ++graphics[name]);
  const draw = (corners, instances = 1) => graphics.draws.push({ corners, instances });
  watch('drawArrays', ([, , corners]) => draw(corners));
  watch('drawElements', ([, corners]) => draw(corners));
  watch('drawArraysInstanced', ([, , corners, instances]) => draw(corners, instances));
  watch('drawElementsInstanced', ([, corners, , , instances]) => draw(corners, instances));
}

let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const scenesWith = (name, report, steps, options = {}) =>
  test(`scenes ${name}`, async () => {
    const file = join(folder, 'report.html');
    writeFileSync(file, template.replace('__ORISPLINE_REPORT_DATA__', () => JSON.stringify(report)));
    const page = await open(browser, file, { first: counting, draws: true, ...options });
    await drawn(page);
    await steps(page);
    await page.finish();
  });

const counts = (page) => page.evaluate(() => ({ contexts: graphics.contexts.length, programs: graphics.linkProgram, buffers: graphics.createBuffer, draws: graphics.draws.splice(0) }));
const clock = async (page) => Number.parseFloat(await page.locator('output').textContent());
const moveTo = (page, time) => page.locator('input[type=range]').fill(String(time));

scenesWith('have one context, and draw all keys and all ghosts at once', many, async (page) => {
  await counts(page);
  await moveTo(page, 12);
  await drawn(page);
  const { contexts, draws } = await counts(page);
  assert.equal(contexts, 1);
  assert.ok(draws.length < 60, `${draws.length} draws of three scenes`);
  const many = (least, size) => draws.filter((draw) => size(draw) > least).length;
  assert.equal(many(10, ({ instances }) => instances), 2, JSON.stringify(draws)); // ghosts of both bodies, few enough for instances
  assert.ok(many(100 * 16 * 3, ({ corners }) => corners) >= 4, JSON.stringify(draws)); // dots and ways, in front and behind
});

scenesWith('keep all but the ways when another method is chosen', many, async (page) => {
  await page.locator('select.first').selectOption('b');
  await drawn(page);
  const once = await counts(page);
  for (const name of ['c', 'a', 'b']) {
    await page.locator('select.first').selectOption(name);
    await drawn(page);
  }
  const { contexts, programs, buffers } = await counts(page);
  assert.deepEqual([contexts, programs], [once.contexts, once.programs]);
  assert.ok(buffers - once.buffers <= 4, `${buffers - once.buffers}`); // of a line that is longer than those before
});

const stage = (page, which) => page.locator(`.stages .${which} canvas`);
/** Of the solid pixels of a scene that are blue: how far they go across, and the darkest. */
const bodyIn = (page, which) =>
  stage(page, which).evaluate((canvas) => {
    const { data, width } = pixelsOf(canvas);
    let [left, right, darkest] = [width, 0, 255];
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b, alpha] = data.subarray(i, i + 4);
      if (alpha < 250 || b < r + 40 || b < g + 10) continue; // its axes have other colours
      const x = (i / 4) % width;
      [left, right, darkest] = [Math.min(left, x), Math.max(right, x), Math.min(darkest, b)];
    }
    return { share: (right - left) / width, darkest };
  });

for (const [form, options] of Object.entries({ 'a wide screen': {}, 'a phone': phone }))
  scenesWith(`show the body as half of the width on ${form}, with light on all of its sides`, inPlace(), async (page) => {
    let widest = 0; // it is seen from its nose, too
    for (const time of [0, 4, 9, 15, 22, 28]) {
      await moveTo(page, time);
      await drawn(page);
      const { share, darkest } = await bodyIn(page, 'first');
      widest = Math.max(widest, share);
      assert.ok(darkest > 60, `${darkest} at ${time} s`);
    }
    assert.ok(widest > 0.35 && widest < 0.6, `${widest}`);
  }, options);

scenesWith('have the names of the axes, and say how large the squares of the ground are', many, async (page) => {
  assert.deepEqual((await page.locator('.stages .first svg text').allTextContents()).sort(), ['x', 'y', 'z']);
  assert.deepEqual((await page.locator('.stages .sphere svg text').allTextContents()).sort(), ['x', 'x', 'y', 'y', 'z', 'z']);
  assert.match(await page.locator('.stages .first .scale').textContent(), /^squares of [125]0? c?m$/);
  await page.locator('.controls label:has-text("Seen") select').selectOption('fixed');
  assert.equal(await page.locator('.stages .first .scale').textContent(), '');
});

const errors = { error_t: [1, 2.5, 3], error_deg: [0.1, 7, null] };
scenesWith('begin at the largest error of the first method', inPlace({ methods: [method('a', sampleTimes, 0.5, errors), method('b', sampleTimes, 0.6)] }), async (page) => assert.equal(await clock(page), 2.5));

const apartAt = (time) => Object.assign(method('b', [0, 5, 10]), { samples: { ...samplesAt([0, time, 10], 0), q: [1, 0, 0, 0, 0.8, 0.6, 0, 0, 1, 0, 0, 0] } });
const still = Object.assign(method('a', [0, 10]), { samples: { ...samplesAt([0, 10], 0), q: [1, 0, 0, 0, 1, 0, 0, 0] } });
const without = { ...many, keys: { t: [0, 10], q: [1, 0, 0, 0, 1, 0, 0, 0], p: [] } };
scenesWith('begin where both methods differ most, where no errors are known', { ...without, methods: [still, apartAt(7.5)] }, async (page) => assert.equal(await clock(page), 7.5));
scenesWith('begin at the start where nothing happens', { ...without, methods: [still, { ...still, name: 'b' }] }, async (page) => assert.equal(await clock(page), 0));

const picture = (page, which) => stage(page, which).evaluate((canvas) => canvas.toDataURL());

scenesWith('say that the graphics were taken away, and go on when they are back', many, async (page) => {
  const sentence = page.locator('.stages .first .lost');
  assert.equal(await sentence.isVisible(), false);
  await page.evaluate(() => (window.taken = graphics.contexts[0].getExtension('WEBGL_lose_context')).loseContext());
  await sentence.waitFor({ state: 'visible' });
  assert.match(await sentence.textContent(), /browser has taken the graphics/);
  assert.deepEqual(await faultsOf(page), []);
  const before = await picture(page, 'first');
  await moveTo(page, 20);
  await drawn(page);
  assert.equal(await page.locator('.plots figure:visible').count() > 3, true);
  assert.equal(await picture(page, 'first'), before); // what was drawn last stays
  await page.evaluate(() => taken.restoreContext());
  await sentence.waitFor({ state: 'hidden' });
  await drawn(page);
  assert.notEqual(await picture(page, 'first'), before);
});

scenesWith('are a sentence where there is no WebGL', many, async (page) => {
  assert.match(await page.locator('.scenes').textContent(), /no WebGL/);
  assert.equal(await page.locator('.stages').count(), 0);
  assert.ok((await page.locator('.plots figure:visible').count()) > 3);
}, { first: withoutGraphics });

const few = times(9, 1);
const along = (places) => places.flatMap((x) => [x, 0, 0]);
const moved = (places) => ({ ...many, keys: { t: few, q: turned(few, 0.5), p: along(places) }, methods: [method('a', few, 0.5, { p: along(places) })] });
for (const [what, places] of [['rests at most of its keys', [0, 0, 0, 0, 0, 1, 1, 1, 1]], ['never leaves its place', few.map(() => 7)]])
  scenesWith(`have a ground of the size of the steps of a body that ${what}`, moved(places), async (page) => {
    for (const place of ['follow', 'path']) {
      await page.evaluate((chosen) => viewer.choose({ place: chosen }), place);
      assert.match(await page.locator('.first .scale').textContent(), /^squares of (5|10|20|50) cm$/, place);
    }
  });

scenesWith('are printed as they are shown', many, async (page) => {
  await page.emulateMedia({ media: 'print' });
  for (const which of ['first', 'second', 'sphere']) {
    const isBlank = await stage(page, which).evaluate((canvas) => pixelsOf(canvas).data.every((value) => value === 0));
    assert.equal(isBlank, false, which);
  }
});

scenesWith('fit on a screen of 320 pixels', many, async (page) => {
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
  assert.deepEqual(await tooWide(page), []);
}, { ...phone, viewport: { width: 320, height: 640 } });
