// SPDX-License-Identifier: Apache-2.0
// The report of an arm whose clips were reduced, in a browser: ARM_PAGE names the file, PICTURES a folder for pictures.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { documentOf } from './document.mjs';
import { drawn, faultsOf, launch, open, phone, screens, tooWide, withoutGraphics } from './browser.mjs';

const file = process.env.ARM_PAGE;
const data = documentOf(file);
const { joints, clips } = data.skeleton;
const largest = (clip, kind) => Math.max(...clip.joints.map((joint) => joint[kind][0]));

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** A test with a page of its own. */
const onPage = (name, options, steps) =>
  test(`of a skeleton ${name}`, async () => {
    const page = await open(browser, file, options);
    await drawn(page);
    await steps(page);
    await page.finish();
  });

const clock = async (page) => Number.parseFloat(await page.locator('output').textContent());
const caption = (page, quantity) => page.locator(`[data-quantity=${quantity}] figcaption`).textContent();
const sceneCaption = (page) => page.locator('.skeleton figcaption').textContent();
const choice = (page, label) => page.locator(`label.choice:has-text("${label}") select`);
const clipNames = (page) => page.locator('.measures tbody th').allTextContents();

onPage('shows every clip, the one that is farthest off first, at its worst', {}, async (page) => {
  assert.equal(await page.title(), data.title);
  assert.equal(await page.locator('pre').textContent(), data.command);
  assert.deepEqual(await clipNames(page), clips.map(({ name }) => name));
  const sorted = clips.map((clip) => largest(clip, 'distance'));
  assert.deepEqual(sorted, [...sorted].sort((a, b) => b - a));
  assert.equal(await page.locator('.measures tr.is-first th').textContent(), clips[0].name);
  const worst = clips[0].joints.find((joint) => joint.distance[0] === sorted[0]);
  assert.ok(Math.abs((await clock(page)) - worst.distance[1]) < 0.01);
  const { distance_step: step } = clips[0].errors;
  const written = (Math.round(sorted[0] / step) * step).toFixed(Math.max(0, Math.floor(-Math.log10(step)))); // no more digits than the step has
  assert.match(await caption(page, 'distance'), new RegExp(`all joints ${written}`));
  assert.match(await sceneCaption(page), new RegExp(`arm.glb.*small.glb.*farthest: .* ${sorted[0].toPrecision(4)} mm`));
});

onPage('has hostile names as plain text', {}, async (page) => {
  const names = joints.map(({ name }) => name);
  assert.ok(names.includes('</script><b>hand'));
  assert.deepEqual((await page.locator('.joints tbody th').allTextContents()).sort(), names.sort());
  assert.equal(await page.locator('b:has-text("hand")').count(), 0);
});

onPage('sorts the clips by a click', {}, async (page) => {
  await page.locator('.measures th[data-id=before] button').click();
  const byKeys = [...clips].sort((a, b) => b.rotation_keys[0] - a.rotation_keys[0]).map(({ name }) => name);
  assert.deepEqual(await clipNames(page), byKeys);
  await page.locator('.measures th[data-id=name] button').click();
  assert.deepEqual(await clipNames(page), clips.map(({ name }) => name).sort());
});

onPage('shows a clip by a click on its row, from its start to its end', {}, async (page) => {
  await page.locator('tr[data-clip="swing 2"] th').click();
  assert.match(await sceneCaption(page), /swing 2/);
  assert.equal(await choice(page, 'Clip').locator('option:checked').textContent(), 'swing 2');
  assert.equal(await page.locator('.joints figcaption').textContent(), 'Joints of swing 2');
  const { start, end } = clips.find(({ name }) => name === 'swing 2');
  const scrub = page.locator('input[type=range]');
  assert.deepEqual([Number(await scrub.getAttribute('min')), Number(await scrub.getAttribute('max'))], [start, end]);
  assert.equal(await clock(page), start);
});

onPage('goes to the worst of a clip and of a joint', {}, async (page) => {
  const clip = clips.find(({ name }) => name === 'swing 4');
  const places = page.locator('tr[data-clip="swing 4"] .moment');
  const joint = clip.joints.findIndex(({ angle_deg }) => angle_deg[0] === largest(clip, 'angle_deg'));
  await places.nth(1).click();
  assert.ok(Math.abs((await clock(page)) - clip.joints[joint].angle_deg[1]) < 0.01);
  assert.equal(await choice(page, 'Joint').locator('option:checked').textContent(), joints[joint].name);
  await page.locator('tr[data-joint=elbow] .moment').first().click();
  const elbow = clip.joints[joints.findIndex(({ name }) => name === 'elbow')];
  assert.ok(Math.abs((await clock(page)) - elbow.distance[1]) < 0.01);
  assert.match(await caption(page, 'angle'), /elbow/);
});

onPage('plots both tolerances, and the errors of the chosen joint', {}, async (page) => {
  assert.match(await caption(page, 'angle'), /tolerance 0\.5/);
  assert.match(await caption(page, 'distance'), /\[mm\].*tolerance 20/);
  await choice(page, 'Joint').selectOption({ label: 'shoulder' });
  assert.match(await caption(page, 'angle'), /shoulder/);
  assert.equal(await page.locator('.joints tr.is-second th').textContent(), 'shoulder');
  const plot = page.locator('[data-quantity=angle] .frame');
  const picture = await plot.screenshot();
  await choice(page, 'Joint').selectOption({ label: 'elbow' });
  await drawn(page);
  assert.notDeepEqual(await plot.screenshot(), picture);
});

onPage('has one cursor, at the time that is shown', {}, async (page) => {
  const [time, { start, end }] = [await clock(page), clips[0]];
  const places = await page.locator('.plots .u-over').evaluateAll((plots) =>
    plots.map((over) => {
      const [line, box] = [over.querySelector('.u-cursor-x').getBoundingClientRect(), over.getBoundingClientRect()];
      return (line.left - box.left) / box.width;
    }),
  );
  assert.equal(places.length, 2);
  for (const at of places) assert.ok(Math.abs(at - (time - start) / (end - start)) < 0.01, `${at}`);
});

onPage('moves, by the button and by the space bar, and begins again at the end of the clip', { draws: true }, async (page) => {
  await page.locator('tr[data-clip="swing 6"] th').click();
  const scene = page.locator('.skeleton .frame');
  await drawn(page);
  const still = await scene.screenshot();
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('output').textContent) > 0.8);
  await page.getByRole('button', { name: 'Pause' }).click();
  assert.notDeepEqual(await scene.screenshot(), still);
  await page.locator('h1').click();
  await page.locator('input[type=range]').evaluate((input) => {
    input.value = input.max - 0.05;
    input.dispatchEvent(new Event('input'));
  });
  await page.keyboard.press('Space');
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('output').textContent) < 2);
});

onPage('is seen from all sides, on its path, and with its differences magnified', { draws: true }, async (page) => {
  const scene = page.locator('.skeleton .frame');
  const pictures = [];
  const take = async () => {
    await drawn(page);
    pictures.push((await scene.screenshot()).toString('base64'));
  };
  for (const name of ['Front', 'Side', 'Back', 'Above']) {
    await page.getByRole('button', { name }).click();
    await take();
  }
  await choice(page, 'Seen').selectOption('path');
  await take();
  await choice(page, 'Differences').selectOption('20');
  await take();
  const { x, y, width, height } = await scene.boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 3, y + height / 2, { steps: 4 });
  await page.mouse.up();
  await take();
  await page.mouse.wheel(0, -400);
  await take();
  assert.equal(new Set(pictures).size, pictures.length);
});

onPage('shows a clip that has no keys without plots', {}, async (page) => {
  await page.locator('tr[data-clip=still] th').click();
  assert.equal(await page.locator('.plots figure[data-quantity]:visible').count(), 0);
  assert.doesNotMatch(await sceneCaption(page), /farthest/);
  await page.locator('tr[data-clip="swing 1"] th').click();
  assert.equal(await page.locator('.plots figure[data-quantity]:visible').count(), 2);
});

onPage('fits on a phone, and follows a finger', phone, async (page) => {
  assert.deepEqual(await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]), [390, 390]);
  assert.deepEqual(await tooWide(page), []);
  const over = page.locator('[data-quantity=distance] .u-over');
  await over.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await over.boundingBox();
  await page.touchscreen.tap(x + 0.6 * width, y + height / 2);
  await drawn(page);
  const { start, end } = clips[0];
  assert.ok(Math.abs((await clock(page)) - (start + 0.6 * (end - start))) < 0.1);
});

for (const [name, options] of Object.entries(screens))
  onPage(`is accessible ${name}`, options, async (page) => assert.deepEqual(await faultsOf(page), []));

onPage('has table and motion on the first screen of a laptop', { viewport: { width: 1440, height: 900 } }, async (page) => {
  const bar = (await page.locator('.playback').boundingBox()).y;
  const [table, scene] = [await page.locator('.measures').boundingBox(), await page.locator('.skeleton').boundingBox()];
  assert.ok(scene.x >= table.x + table.width);
  for (const { y, height } of [table, scene]) assert.ok(y + height <= bar);
});

/** The page of one motion, of the data of the first ones. */
function alone() {
  const one = structuredClone(data);
  Object.assign(one.skeleton, { after: '', unit: '' });
  for (const clip of one.skeleton.clips) {
    Object.assign(clip.poses, { after: [], offset_step: 1 });
    for (const counts of [clip.rotation_keys, clip.translation_keys, ...clip.joints.map(({ keys }) => keys)]) counts[1] = 0;
  }
  return one;
}

for (const [name, options] of [['', {}], [' on a phone', phone]])
  test(`of one motion of a skeleton shows it alone${name}`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'orispline-page-'));
    const single = join(folder, 'one.html');
    const text = JSON.stringify(alone()).replaceAll('<', '\\u003c');
    writeFileSync(single, readFileSync(file, 'utf8').replace(/(id="report-data">).*?(<\/script>)/s, (_, start, end) => start + text + end));
    const page = await open(browser, single, options);
    await drawn(page);
    assert.deepEqual(await clipNames(page), clips.map(({ name: clip }) => clip)); // in their order
    const heads = await page.locator('.measures th[data-id]').evaluateAll((all) => all.map((head) => head.dataset.id));
    assert.deepEqual(heads, ['name', 'before', 'distance', 'distance_at', 'angle_deg', 'angle_at', 'duration']);
    assert.equal(await page.locator('.measures tbody tr').first().locator('td').count(), heads.length - 1);
    assert.deepEqual(await page.locator('.joints tbody th').allTextContents(), joints.map(({ name: joint }) => joint));
    const [, farthest] = alone().skeleton.clips[0].joints.map(({ distance }) => distance).reduce((most, one) => (one[0] > most[0] ? one : most));
    assert.ok(Math.abs((await clock(page)) - farthest) < 0.01); // where something happens
    assert.doesNotMatch(await sceneCaption(page), /small\.glb|farthest/);
    assert.match(await sceneCaption(page), /arm\.glb/);
    assert.match(await caption(page, 'distance'), /Shell distance from where the clip begins in the world \[units\]/);
    assert.equal(await page.locator('label.choice:has-text("Differences")').count(), 0);
    await page.locator('.measures tbody tr').nth(2).click();
    await drawn(page);
    assert.equal(await page.locator('.measures tr.is-first th').textContent(), clips[2].name);
    assert.deepEqual(await faultsOf(page), []);
    assert.deepEqual(await tooWide(page), []);
    await page.finish();
    rmSync(folder, { recursive: true });
  });

test('of a skeleton shows the rest where there is no WebGL', async () => {
  const page = await open(browser, file, { first: withoutGraphics });
  assert.match(await page.locator('.scenes').textContent(), /no WebGL/);
  assert.equal(await page.locator('.plots figure:visible').count(), 3);
  await page.finish();
});

const pictures = { light: { height: 1500 }, dark: { height: 1500, colorScheme: 'dark' }, phone: { width: 390, height: 844 } };
test('of a skeleton has its picture taken', { skip: !process.env.PICTURES }, async () => {
  for (const [name, { width = 1400, height, colorScheme }] of Object.entries(pictures)) {
    const page = await open(browser, file, { viewport: { width, height }, colorScheme, draws: true });
    await drawn(page);
    await page.screenshot({ path: join(process.env.PICTURES, `skeleton-${name}.png`) });
    await page.finish();
  }
});
