// SPDX-License-Identifier: Apache-2.0
// The built page, opened from the disk in a real browser, with keys in it as the command writes them; what one does to it by mouse, finger
// and keyboard; and what it then holds.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch, unseen } from '../../report/tests/browser.mjs';

const built = readFileSync(process.env.ORISPLINE_STUDIO_PAGE, 'utf8');
const marker = '__ORISPLINE_STUDIO_DATA__';
const folder = mkdtempSync(join(tmpdir(), 'orispline-page-'));
let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** Where a test may put files. */
export const placeOf = (name) => join(folder, name);

export const example = (name) => readFileSync(join(process.env.ORISPLINE_EXAMPLES, name), 'utf8');

export const five = 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2.5,0.6,0,0.8,0\n4,0,0,1,0\n5,0.6,0,0,0.8\n';

const encoded = (value) => JSON.stringify(value).replaceAll('<', '\\u003c');

/** A page with keys; without text the one that opens with a motion. */
function pageWith({ text, bytes = text === undefined ? undefined : Buffer.from(text), name = 'keys.csv', method = null, beside = null }) {
  if (bytes === undefined) return process.env.ORISPLINE_STUDIO_PAGE;
  const file = placeOf('studio.html');
  const data = encoded({ studio: 1, version: '0.2.0', name, content: Buffer.from(bytes).toString('base64'), method, beside });
  writeFileSync(file, built.replace(marker, () => data));
  return file;
}

/** In the page, before all else: the document whose curves came last is `drawnOf`; `did` counts presses that it hears and files that it gives to the browser. */
function watched() {
  let app;
  const did = (globalThis.did = { hear: 0, give: 0 });
  for (const press of ['keydown', 'click']) addEventListener(press, ({ isTrusted }) => (did.hear += isTrusted), true);
  const { click } = HTMLAnchorElement.prototype;
  HTMLAnchorElement.prototype.click = function () {
    did.give += this.download !== '';
    click.call(this);
  };
  const put = (given) => {
    app = given;
    app.engine.onCurves((_, of) => (globalThis.drawnOf = of));
  };
  Object.defineProperty(globalThis, 'studio', { get: () => app, set: put });
}

/** In the page, before all else: who opens it knows it, and wants all controls. */
function known() {
  try {
    for (const habit of ['more', 'toured']) localStorage.setItem(`orispline-studio-${habit}`, '1');
  } catch {
    // A test may forbid it.
  }
}

/** A browser of its own, for pages that share what it keeps. */
export const profile = (options = {}) => browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });

const isOwn = (url, page) => url === page || url.startsWith('blob:');

/**
 * The page with keys in it, in a profile, for somebody who knows it, or is `new`. `first` runs in it before all else, `complaints` are those that it may have. It comes when all is
 * drawn; `finish` closes it, and finds that it asked for nothing and complained of nothing.
 */
export async function studioWith(given = {}, { within, first, complaints: allowed = [], new: isNew = false, ...options } = {}) {
  const context = within ?? (await profile(options));
  const page = await context.newPage();
  page.setDefaultTimeout(120_000); // other work may be beside it
  await page.addInitScript(watched);
  await page.addInitScript(unseen);
  if (!isNew) await page.addInitScript(known);
  if (first) await page.addInitScript(typeof first === 'string' ? { content: first } : first);
  const [complaints, requests] = [[], []];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  const url = pathToFileURL(pageWith(given)).href;
  page.on('request', (request) => isOwn(request.url(), url) || requests.push(request.url()));
  await page.goto(url);
  const studio = new Studio(page, async () => {
    await (within ? page.close() : context.close());
    assert.deepEqual(complaints.filter((one) => !allowed.some((is) => is.test(one))), []);
    assert.deepEqual(requests, []);
  });
  if (given.text !== undefined || given.bytes) await studio.isOpen(given.name ?? 'keys.csv');
  return studio;
}

const centreOf = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2, width, height };
};

export class Studio {
  constructor(page, finish) {
    Object.assign(this, { page, finish, keyboard: page.keyboard });
  }

  async isOpen(name) {
    await this.page.getByRole('heading', { name, exact: false, level: 1 }).waitFor();
    await this.drawn();
  }

  /** Until curves are those of the keys as they are, and on the screen. */
  async drawn() {
    await this.page.waitForFunction(() => studio.current && drawnOf === studio.current.studio.store.current().document);
    await this.frames();
  }

  /** What a function tells of `{ store, view, engine, methods, original }` in the page. */
  ask(read, given) {
    return this.page.evaluate(`(${read})(studio.current.studio, ${JSON.stringify(given ?? null)})`);
  }

  keys = () => this.ask(({ store }) => store.current().document.keys);
  times = async () => (await this.keys()).map(({ t }) => t);
  chosen = () => this.ask(({ store }) => store.current().document.keys.findIndex(({ id }) => id === store.current().chosen) + 1);
  time = () => this.ask(({ view }) => view.current().time);
  choose = (n) => this.ask(({ store }, n) => store.choose(store.current().document.keys[n - 1].id), n);

  /** How many steps lead back; the document is then the first one. */
  stepsBack = () =>
    this.ask(({ store }) => {
      let steps = 0;
      for (; store.current().canUndo; ++steps) store.undo();
      return steps;
    });

  button = (name, options = {}) => this.page.getByRole('button', { name, exact: true, ...options });
  group = (name) => this.page.getByRole('group', { name, exact: true });
  dialog = (name) => this.page.getByRole('dialog', { name });
  dot = (n) => this.page.getByRole('slider', { name: `Key ${n}`, exact: true });
  bar = (n, name = 'tension') => this.page.getByRole('slider', { name: `${name} of key ${n}`, exact: true });
  field = (name) => this.group('Key').getByRole('textbox', { name, exact: true });
  method = (letter) => this.page.getByRole('combobox', { name: letter, exact: true });
  scene = (name) => this.group(name).getByRole('application');
  notice = (text) => this.page.locator('.notices').getByText(text);

  /** The file that an act saves. A browser may lose the press or the file; then it is done again, as a user does. What the page itself does not do is a fault. */
  download = async (act) => {
    const did = () => this.page.evaluate(() => ({ ...globalThis.did }));
    for (let tries = 3; tries > 0; --tries) {
      const before = await did();
      const [download] = await Promise.all([this.page.waitForEvent('download', { timeout: 60_000 }).catch(() => null), act()]);
      if (download) return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
      const { hear, give } = await did();
      const told = await this.page.locator('.notices').textContent();
      assert.ok(hear === before.hear || give > before.give, `the page heard a press and saved nothing; it says: ${told}`);
    }
    assert.fail('three times the browser lost a press or a file');
  };

  async type(field, text) {
    await field.fill(text);
    await field.press('Enter');
  }

  async drag(from, ...places) {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    for (const { x, y } of places) await mouse.move(x, y, { steps: 5 });
    await mouse.up();
  }

  async dragBy(locator, dx, dy) {
    const from = await centreOf(locator);
    await this.drag(from, { x: from.x + dx, y: from.y + dy });
  }

  centreOf = centreOf;

  /** A finger, which a browser takes for the page's where nothing holds it. */
  async finger(from, ...places) {
    this.session ??= await this.page.context().newCDPSession(this.page);
    const touch = (type, ...touchPoints) => this.session.send('Input.dispatchTouchEvent', { type, touchPoints });
    await touch('touchStart', from);
    for (const place of places) for (let part = 0.25; part <= 1; part += 0.25) await touch('touchMove', { x: from.x + part * (place.x - from.x), y: from.y + part * (place.y - from.y) });
    await touch('touchEnd');
  }

  /** A tap. A browser drops one that a busy page does not take in time; then it is done again, as a user does. */
  async tap(locator) {
    const click = await locator.evaluateHandle((one) => {
      const click = { isHeard: false };
      one.addEventListener('click', () => (click.isHeard = true), { once: true });
      return click;
    });
    const isHeard = () => this.page.waitForFunction((click) => click.isHeard, click, { timeout: 2000 }).then(() => true, () => false);
    do await locator.tap();
    while (!(await isHeard()));
  }

  /** Until the page has been drawn twice. */
  frames = () => this.page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

  /** Where the handle of a key is on the sphere. */
  handle = (n) =>
    this.group('Sphere').locator('.handle').nth(n - 1).evaluate((one) => {
      const { left, top } = one.ownerSVGElement.getBoundingClientRect();
      return { x: left + Number(one.getAttribute('cx')), y: top + Number(one.getAttribute('cy')), isBehind: one.classList.contains('behind') };
    });

  middle = (name) => centreOf(this.scene(name));

  /** Drops a file on the page, or pastes a text. */
  drop = (name, text) =>
    this.page.evaluate(([name, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name));
      document.querySelector('.orispline-studio').dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
    }, [name, text]);
  paste = (text) =>
    this.page.evaluate((text) => {
      const data = new DataTransfer();
      data.setData('text/plain', text);
      document.querySelector('.orispline-studio').dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
}

/** To run before a page: files of the disk as pickers give them, by their names; \`disk\` has their texts. */
export function withDisk() {
  globalThis.disk = {};
  const handleOf = (name) => ({
    name,
    getFile: async () => new Blob([globalThis.disk[name]]),
    createWritable: async () => {
      let written = '';
      return { write: async (bytes) => (written += new TextDecoder().decode(bytes)), close: async () => (globalThis.disk[name] = written) };
    },
  });
  globalThis.showOpenFilePicker = async () => [handleOf(globalThis.picked)];
  globalThis.showSaveFilePicker = async () => handleOf(globalThis.picked);
}

const product = ([w, x, y, z], [a, b, c, d]) => [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];

/** The rotation vector from one orientation to another [deg], in the world or in the body. */
export function turnOf(from, to, space = 'world') {
  const inverse = [from[0], -from[1], -from[2], -from[3]];
  const [w, ...v] = space === 'world' ? product(to, inverse) : product(inverse, to);
  const size = Math.hypot(...v);
  const angle = (2 * Math.atan2(w < 0 ? -size : size, Math.abs(w)) * 180) / Math.PI;
  return v.map((part) => (size > 0 ? (part / size) * angle : 0));
}

export const about = (axis, angle) => {
  const size = Math.hypot(...axis);
  const half = (angle * Math.PI) / 360;
  return [Math.cos(half), ...axis.map((part) => (part / size) * Math.sin(half))];
};
