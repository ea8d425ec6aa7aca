// SPDX-License-Identifier: Apache-2.0
// Keys that are turned in the scenes, by mouse, finger and keyboard, in a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawn, faultsOf, phone, screens, withoutGraphics } from '../../report/tests/browser.mjs';
import { opener } from './opener.mjs';
import { scenePage } from './scenePage.mjs';

const degree = Math.PI / 180;
const about = (axis, angle) => {
  const length = Math.hypot(...axis);
  return [Math.cos((angle * degree) / 2), ...axis.map((part) => (part / length) * Math.sin((angle * degree) / 2))];
};
const keys = [[0, about([0, 0, 1], 0)], [1, about([0, 0, 1], 50)], [2, about([0, 1, 0.5], 40)], [3.5, about([1, 0.5, 0.2], 100)], [5, about([0, 1, 1], 140)]];

const product = ([w, x, y, z], [a, b, c, d]) => [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];
const inverse = ([w, x, y, z]) => [w, -x, -y, -z];
const dot = (some, others) => some.reduce((sum, value, i) => sum + value * others[i], 0);
/** The rotation vector in the world from one orientation to another [rad]. */
function turnOf(from, to) {
  const [w, ...v] = product(to, inverse(from));
  const size = Math.hypot(...v);
  const angle = 2 * Math.atan2(w < 0 ? -size : size, Math.abs(w));
  return v.map((part) => (size > 0 ? (part / size) * angle : 0));
}
const xAxis = ([w, x, y, z]) => [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];

const opened = opener(scenePage);

const onPage = (name, steps, options = {}) =>
  test(name, async () => {
    const page = await opened({ viewport: { width: 1200, height: 540 }, ...options });
    await page.evaluate((given) => showKeys(given), options.keys ?? keys);
    await drawn(page);
    await steps(page);
    await page.finish();
  });

const quaternions = (page) => page.evaluate(() => studio.store.current().document.keys.map(({ q }) => q));
const canvasOf = (page, name) => page.getByRole('group', { name }).locator('canvas');
const choose = async (page, id) => {
  await page.evaluate((id) => studio.store.choose(id), id);
  await drawn(page);
};
/** Where the handle of a key is, on the page. */
const handleOf = (page, id) =>
  page.getByRole('group', { name: 'Sphere' }).locator('.handle').nth(id - 1).evaluate((one) => {
    const { left, top } = one.ownerSVGElement.getBoundingClientRect();
    return { x: left + Number(one.getAttribute('cx')), y: top + Number(one.getAttribute('cy')), isBehind: one.classList.contains('behind') };
  });
const middleOf = async (page, name) => {
  const { x, y, width, height } = await canvasOf(page, name).boundingBox();
  return { x: x + width / 2, y: y + height / 2, width, height };
};

async function pull(page, from, ...places) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (const { x, y } of places) await page.mouse.move(x, y, { steps: 5 });
  await drawn(page);
}

async function undoneOnce(page) {
  return page.evaluate(() => {
    studio.store.undo();
    return { document: studio.store.current().document.keys.map(({ q }) => q), canUndo: studio.store.current().canUndo };
  });
}
const wereKeys = keys.map(([, q]) => q);

onPage('a handle on the sphere follows the mouse by the smallest turn of its key, in one step', async (page) => {
  await choose(page, 2);
  await page.evaluate(() => studio.view.choose({ time: 4, playing: true }));
  const from = await handleOf(page, 4);
  const middle = await middleOf(page, 'Sphere');
  const to = { x: middle.x + 40, y: middle.y - 30 };
  await pull(page, from, { x: middle.x - 60, y: middle.y }, to);
  await page.mouse.up();
  const handle = await handleOf(page, 4);
  assert.ok(Math.hypot(handle.x - to.x, handle.y - to.y) < 1 && !handle.isBehind === !from.isBehind, JSON.stringify([handle, to]));
  const after = await quaternions(page);
  const turn = turnOf(wereKeys[3], after[3]);
  const [a, b] = [xAxis(wereKeys[3]), xAxis(after[3])];
  assert.ok(Math.abs(dot(turn, a)) < 1e-12 && Math.abs(dot(turn, b)) < 1e-12, `${turn}`);
  assert.ok(Math.abs(Math.hypot(...turn) - Math.acos(dot(a, b))) < 1e-9);
  for (const other of [0, 1, 2, 4]) assert.ok(1 - Math.abs(dot(after[other], wereKeys[other])) < 1e-15);
  assert.equal(await canvasOf(page, 'Sphere').evaluate((canvas) => canvas === document.activeElement), true);
  const { chosen, time, playing } = await page.evaluate(() => ({ ...studio.view.current(), chosen: studio.store.current().chosen }));
  assert.deepEqual([chosen, time, playing], [4, 3.5, false]);
  assert.deepEqual(await undoneOnce(page), { document: wereKeys, canUndo: false });
});

onPage('beyond the edge of the sphere the handle is at the nearest point of its outline', async (page) => {
  const middle = await middleOf(page, 'Sphere');
  const from = await handleOf(page, 2);
  const reached = [];
  await pull(page, from, { x: middle.x, y: middle.y });
  for (const [x, y] of [[200, 30], [270, 40.5], [-150, 150], [20, -210]]) {
    await page.mouse.move(middle.x + x, middle.y + y);
    await drawn(page);
    const handle = await handleOf(page, 2);
    const [dx, dy] = [handle.x - middle.x, handle.y - middle.y];
    assert.ok(Math.abs(dx * y - dy * x) / Math.hypot(x, y) < 1 && dx * x + dy * y > 0, `${[dx, dy, x, y]}`);
    reached.push(Math.hypot(dx, dy));
  }
  await page.mouse.up();
  assert.ok(Math.max(...reached) - Math.min(...reached) < 1, `${reached}`);
  assert.ok(reached[0] > 100, `${reached}`);
});

onPage('a click on a handle chooses its key and turns nothing, and Escape gives a pull up', async (page) => {
  const before = await quaternions(page);
  const from = await handleOf(page, 3);
  await page.mouse.click(from.x + 8, from.y + 8); // 24 px are the handle
  assert.equal(await page.evaluate(() => studio.store.current().chosen), 3);
  await pull(page, from, { x: from.x + 60, y: from.y + 10 });
  assert.notDeepEqual(await quaternions(page), before);
  await page.keyboard.press('Escape');
  assert.deepEqual(await quaternions(page), before);
  await page.mouse.move(from.x + 90, from.y);
  await page.mouse.up();
  assert.deepEqual(await quaternions(page), before);
  assert.equal(await page.evaluate(() => studio.store.current().canUndo), false);
});

onPage('what is empty of the sphere turns the camera, and no key', async (page) => {
  const middle = await middleOf(page, 'Sphere');
  const before = await handleOf(page, 1);
  await pull(page, { x: middle.x + 60, y: middle.y + 190 }, { x: middle.x + 120, y: middle.y + 190 });
  await page.mouse.up();
  const after = await handleOf(page, 1);
  assert.ok(Math.hypot(after.x - before.x, after.y - before.y) > 10);
  assert.deepEqual(await quaternions(page), wereKeys);
});

/** Where a ring is right of the middle, and how the key then turned when it was pulled. */
async function pullRing(page) {
  const middle = await middleOf(page, 'Body');
  for (let x = middle.x + 60; x < middle.x + middle.width / 2; x += 4) {
    await page.mouse.move(x, middle.y + 30);
    if ((await canvasOf(page, 'Body').evaluate(({ style }) => style.cursor)) === 'grab') {
      await pull(page, { x, y: middle.y + 30 }, { x: x - 20, y: middle.y + 90 });
      return;
    }
  }
  assert.fail('found no ring');
}

for (const space of ['world axes', 'body axes'])
  onPage(`a ring of the gizmo turns the key about one of the ${space}, in one step`, async (page) => {
    await choose(page, 3);
    await page.getByLabel('Rings').selectOption(space);
    await drawn(page);
    await pullRing(page);
    assert.equal(await page.evaluate(() => studio.view.current().time), 2);
    await page.mouse.up();
    const after = await quaternions(page);
    const turn = turnOf(wereKeys[2], after[2]);
    const inSpace = space === 'world axes' ? turn : product(product(inverse(wereKeys[2]), [0, ...turn]), wereKeys[2]).slice(1);
    const sizes = inSpace.map(Math.abs).sort((a, b) => b - a);
    assert.ok(sizes[0] > 10 * degree && sizes[1] < 1e-12, `${inSpace}`);
    assert.deepEqual(await undoneOnce(page), { document: wereKeys, canUndo: false });
  });

onPage('Escape gives the pull of a ring up', async (page) => {
  await choose(page, 3);
  await pullRing(page);
  assert.notDeepEqual(await quaternions(page), wereKeys);
  await page.keyboard.press('Escape');
  const middle = await middleOf(page, 'Body');
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.up();
  assert.deepEqual(await quaternions(page), wereKeys);
  assert.equal(await page.evaluate(() => studio.store.current().canUndo), false);
});

onPage('beside the gizmo the camera turns in the scene of the body', async (page) => {
  await choose(page, 3);
  const middle = await middleOf(page, 'Body');
  const triad = () => page.getByRole('group', { name: 'Body' }).locator('line').evaluateAll((all) => all.map((line) => line.getAttribute('x2')).sort().join());
  const before = await triad();
  await pull(page, { x: middle.x + 180, y: middle.y + 180 }, { x: middle.x + 120, y: middle.y + 180 });
  await page.mouse.up();
  assert.notEqual(await triad(), before);
  assert.deepEqual(await quaternions(page), wereKeys);
});

onPage('a click on a neighbour of the chosen key chooses it', async (page) => {
  await choose(page, 3);
  const middle = await middleOf(page, 'Body');
  assert.deepEqual((await page.getByRole('group', { name: 'Body' }).locator('svg text').allTextContents()).filter((text) => text.startsWith('key')), ['key 2', 'key 4']);
  await page.mouse.click(middle.x + middle.width / 2 - 60, middle.y);
  assert.equal(await page.evaluate(() => studio.store.current().chosen), 4);
});

for (const name of ['Body', 'Sphere'])
  onPage(`with the focus on ${name}, keys turn the chosen key about the axes of the screen`, async (page) => {
    await choose(page, 3);
    await canvasOf(page, name).focus();
    const pressed = async (key) => {
      const before = (await quaternions(page))[2];
      await page.keyboard.press(key);
      return turnOf(before, (await quaternions(page))[2]).map((part) => part / degree);
    };
    const near = (some, others) => some.every((value, i) => Math.abs(value - others[i]) < 1e-12);
    const [right, up, eye] = [await pressed('ArrowDown'), await pressed('ArrowRight'), await pressed('PageUp')];
    for (const axis of [right, up, eye]) assert.ok(Math.abs(Math.hypot(...axis) - 1) < 1e-12, `${axis}`);
    const cross = [right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2], right[0] * up[1] - right[1] * up[0]];
    assert.ok(near(cross, eye) && Math.abs(right[2]) < 1e-12 && up[2] > 0, `${[right, up, eye]}`); // z is upwards on the screen
    for (const [key, axis, angle] of [['ArrowUp', right, -1], ['ArrowLeft', up, -1], ['PageDown', eye, -1], ['Shift+ArrowRight', up, 10], ['Control+ArrowDown', right, 0.1], ['Shift+PageDown', eye, -10]])
      assert.ok(near(await pressed(key), axis.map((part) => angle * part)), key);
    assert.deepEqual(await undoneOnce(page), { document: wereKeys, canUndo: false }); // all of it was one gesture
  });

for (const name of ['Body', 'Sphere'])
  onPage(`with the focus on ${name}, Alt with arrows turns the view and no key`, async (page) => {
    await choose(page, 3);
    await canvasOf(page, name).focus();
    const directions = () =>
      page.getByRole('group', { name }).locator('svg line').evaluateAll((all) => all.map((line) => ['x1', 'y1', 'x2', 'y2'].map((end) => Number(line.getAttribute(end))).join()).join(' '));
    const shown = () => (name === 'Body' ? directions() : handleOf(page, 1).then(({ x, y }) => `${Math.round(x)} ${Math.round(y)}`));
    const seen = [await shown()];
    for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowDown']) {
      await page.keyboard.press(`Alt+${key}`);
      await drawn(page);
      seen.push(await shown());
    }
    assert.equal(new Set(seen.slice(0, 4)).size, 4, seen.join('\n'));
    if (name === 'Sphere') assert.equal(seen[4], seen[0]);
    for (let i = 0; i < 50; ++i) await page.keyboard.press('Alt+ArrowUp'); // the eye stays below the zenith
    await drawn(page);
    assert.doesNotMatch(await shown(), /NaN/);
    assert.deepEqual(await quaternions(page), wereKeys);
    assert.equal(await page.evaluate(() => studio.store.current().canUndo), false);
  });

onPage('arrows move what is in front on the sphere as they point, and another key is another step', async (page) => {
  const middle = await middleOf(page, 'Sphere');
  await pull(page, await handleOf(page, 2), { x: middle.x, y: middle.y });
  await page.mouse.up();
  await canvasOf(page, 'Sphere').focus();
  for (const [key, x, y] of [['ArrowLeft', -1, 0], ['ArrowRight', 1, 0], ['ArrowUp', 0, -1], ['ArrowDown', 0, 1]]) {
    const before = await handleOf(page, 2);
    await page.keyboard.press(`Shift+${key}`);
    await drawn(page);
    const after = await handleOf(page, 2);
    assert.ok((after.x - before.x) * x + (after.y - before.y) * y > 10, key);
  }
  const before = await quaternions(page);
  await choose(page, 1);
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual((await undoneOnce(page)).document, before);
});

onPage('a scene tells the chosen key and how it is turned, and which keys to press', async (page) => {
  await choose(page, 2);
  const scene = page.getByRole('group', { name: 'Body' }).getByRole('application');
  assert.equal(await scene.getAttribute('aria-label'), 'Key 2 of 5 at 1.000 s: yaw 50.0°, pitch 0°, roll 0°');
  assert.match(await page.locator(`#${await scene.getAttribute('aria-describedby')}`).textContent(), /^Arrow keys, Page Up and Page Down turn the chosen key by 1°, .* 0\.1°\. Alt with arrow keys turns the view\.$/);
  await scene.focus();
  await page.keyboard.press('Shift+ArrowUp');
  assert.match(await page.getByRole('group', { name: 'Body' }).getByRole('status').first().textContent(), /^Key 2 of 5/);
  await choose(page, null);
  assert.equal(await scene.getAttribute('aria-label'), 'Body: no key is chosen');
});

/** A finger, which a browser takes for the page's where nothing holds it. */
async function fingerPull(page, from, ...places) {
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', from);
  for (const place of places) for (let part = 0.25; part <= 1; part += 0.25) await touch('touchMove', { x: from.x + part * (place.x - from.x), y: from.y + part * (place.y - from.y) });
  await touch('touchEnd');
  await drawn(page);
}

onPage('a finger pulls a handle, and the page stays', async (page) => {
  await page.evaluate(() => (document.body.style.paddingBottom = '600px'));
  await choose(page, 2);
  const from = await handleOf(page, 2);
  const to = { x: from.x - 30, y: from.y - 90 };
  await fingerPull(page, { x: from.x + 13, y: from.y + 13 }, to); // 44 px are the handle
  const handle = await handleOf(page, 2);
  assert.ok(Math.hypot(handle.x - to.x, handle.y - to.y) < 1, JSON.stringify([handle, to]));
  assert.equal(await page.evaluate(() => scrollY), 0);
  assert.equal(await canvasOf(page, 'Sphere').evaluate((canvas) => canvas === document.activeElement), true);
  assert.deepEqual(await undoneOnce(page), { document: wereKeys, canUndo: false });
}, phone);

onPage('a finger turns a ring, and the page stays', async (page) => {
  await page.evaluate(() => (document.body.style.paddingBottom = '600px'));
  await choose(page, 3);
  const middle = await middleOf(page, 'Body');
  await fingerPull(page, { x: middle.x, y: middle.y + (0.3 * middle.width) / 2 }, { x: middle.x + 60, y: middle.y + 70 });
  const turn = turnOf(wereKeys[2], (await quaternions(page))[2]).map(Math.abs);
  assert.ok(Math.max(...turn) > 5 * degree && turn.toSorted((a, b) => a - b)[1] < 1e-12, `${turn}`);
  assert.equal(await page.evaluate(() => scrollY), 0);
}, phone);

const picture = (page, name) => canvasOf(page, name).evaluate((canvas) => canvas.toDataURL());

onPage('what is dragged is drawn before its curve is there', async (page) => {
  await choose(page, 3);
  await page.evaluate(() => (studio.view.replace = () => {}));
  await page.evaluate(() => studio.view.moveTo(2));
  await drawn(page);
  const before = [await picture(page, 'Body'), await picture(page, 'Sphere')];
  await canvasOf(page, 'Body').focus();
  await page.keyboard.press('Shift+PageUp');
  await drawn(page);
  assert.notEqual(await picture(page, 'Body'), before[0]);
  assert.notEqual(await picture(page, 'Sphere'), before[1]);
}, { draws: true });

onPage('keys with positions stand on their path', async (page) => {
  await choose(page, 3);
  await drawn(page);
  const before = await picture(page, 'Body');
  await choose(page, 4);
  await page.evaluate(() => studio.view.moveTo(3.5));
  await drawn(page);
  assert.notEqual(await picture(page, 'Body'), before);
}, { draws: true, keys: keys.map(([t, q], i) => [t, q, [3 * i, 2 * Math.sin(i), 0.5 * i]]) });

onPage('another axis of the world is up, in both scenes, and keys turn about the screen as it is then', async (page) => {
  const triadOf = (name) => page.getByRole('group', { name }).locator('svg > g text').evaluateAll((texts) => Object.fromEntries(texts.map((one) => [one.textContent, Number(one.getAttribute('y'))])));
  await choose(page, 2);
  for (const name of ['Body', 'Sphere']) {
    const { x, y, z } = await triadOf(name);
    assert.ok(z < x && z < y, `z is up in ${name}`);
  }
  await page.getByLabel('Up').selectOption('y up');
  await drawn(page);
  for (const name of ['Body', 'Sphere']) {
    const { x, y, z } = await triadOf(name);
    assert.ok(y < x && y < z, `y is up in ${name}`);
  }
  const before = (await quaternions(page))[1];
  await canvasOf(page, 'Body').focus();
  await page.keyboard.press('ArrowRight');
  const [x, y, z] = turnOf(before, (await quaternions(page))[1]);
  assert.ok(y > 0.7 * degree && y > Math.abs(x) && y > Math.abs(z), [x, y, z].join());
  const { x: left, y: top, width, height } = await canvasOf(page, 'Body').boundingBox();
  await pull(page, { x: left + 0.06 * width, y: top + 0.1 * height }, { x: left + 0.3 * width, y: top + 0.1 * height }); // what is empty turns the camera about y
  const turned = await triadOf('Body');
  assert.ok(turned.y < turned.x && turned.y < turned.z);
  await page.mouse.up();
  await page.getByLabel('Shape').selectOption('camera');
  await drawn(page);
});

test('scenes come and go without a rest, and are drawn with one context', async () => {
  const page = await opened({ viewport: { width: 1200, height: 540 }, draws: true });
  for (let i = 0; i < 20; ++i) {
    await page.evaluate((keys) => showKeys(keys), keys);
    await drawn(page);
    const left = await page.evaluate(() => {
      const { store, view } = studio;
      globalThis.heard = 0;
      const own = view.current;
      view.current = () => (++heard, own());
      view.destroy();
      heard = 0;
      store.edit({ ...store.current().document, keys: store.current().document.keys.slice(1) });
      return [document.querySelector('main'), heard];
    });
    assert.deepEqual(left, [null, 0]);
  }
  await page.evaluate((keys) => showKeys(keys), keys);
  await drawn(page);
  for (const name of ['Body', 'Sphere']) assert.ok(await canvasOf(page, name).evaluate((canvas) => pixelsOf(canvas).data.some((value) => value > 0)));
  await page.finish();
});

onPage('without WebGL a sentence stands in place of each scene, and keys are edited', async (page) => {
  for (const name of ['Body', 'Sphere']) assert.match(await page.getByRole('group', { name }).textContent(), /This scene is not shown: this browser has no WebGL\./);
  await page.evaluate(() => studio.store.edit({ ...studio.store.current().document, keys: studio.store.current().document.keys.slice(1) }));
  assert.equal(await page.evaluate(() => studio.view.current().extent[0]), 1);
  assert.deepEqual(await faultsOf(page), []);
}, { first: withoutGraphics });

function keepingContext() {
  const own = OffscreenCanvas.prototype.getContext;
  OffscreenCanvas.prototype.getContext = function (kind, ...more) {
    const context = own.call(this, kind, ...more);
    if (kind === 'webgl2') globalThis.graphics = context;
    return context;
  };
}

onPage('scenes say that the graphics were taken away, and go on when they are back', async (page) => {
  const sentences = page.locator('.lost');
  await page.evaluate(() => (globalThis.taken = graphics.getExtension('WEBGL_lose_context')).loseContext());
  await sentences.first().waitFor({ state: 'visible' });
  assert.equal(await page.locator('.lost:visible').count(), 2);
  const before = await picture(page, 'Body');
  await page.evaluate(() => taken.restoreContext());
  await sentences.first().waitFor({ state: 'hidden' });
  await choose(page, 4);
  await drawn(page);
  assert.notEqual(await picture(page, 'Body'), before);
}, { first: keepingContext, draws: true });

for (const [name, options] of Object.entries(screens))
  onPage(`the scenes are accessible ${name}`, async (page) => {
    await choose(page, 3);
    await canvasOf(page, 'Body').focus();
    assert.deepEqual(await faultsOf(page), []);
  }, options);
