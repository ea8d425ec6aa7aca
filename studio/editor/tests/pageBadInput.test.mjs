// SPDX-License-Identifier: Apache-2.0
// What can go wrong on the built page: a sentence each, and nothing is lost.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { withoutGraphics } from '../../report/tests/browser.mjs';
import { example, five, profile, studioWith, withDisk } from './wholePage.mjs';

const { wanted } = JSON.parse(readFileSync(new URL('../src/document/browsers.json', import.meta.url), 'utf8'));
const header = 't,qw,qx,qy,qz\n';
const wholeSentence = /^\S.*\S\.$/s;

/** What is not opened, with what its sentence says. */
const refused = {
  'an empty file': ['', /empty|no/i],
  'a binary file': [[0x7f, 0x45, 0x4c, 0x46, 0, 1, 2, 3, 0xff, 0xfe, 10, 0], /binary|text|NUL|found/i],
  'a file in UTF-16': [[0xff, 0xfe, ...[...`${header}0,1,0,0,0\n`].flatMap((c) => [c.charCodeAt(0), 0])], /UTF-16/],
  'a file without a header': ['0,1,0,0,0\n1,0.8,0.6,0,0\n', /header|column/],
  'a text that is no table': ['Dear all,\nthe keys are attached.\n', /./],
  'a number that is none': [`${header}0,1,0,0,0\n1,nan,0.6,0,0\n`, /nan/i],
  'equal times': [`${header}0,1,0,0,0\n1,0.8,0.6,0,0\n1,0.6,0,0.8,0\n`, /time|equal|increas/i],
  'decreasing times': [`${header}0,1,0,0,0\n2,0.8,0.6,0,0\n1,0.6,0,0.8,0\n`, /time|increas/i],
  'a zero quaternion': [`${header}0,1,0,0,0\n1,0,0,0,0\n`, /quaternion|norm/i],
  'markup': ['</script><img src=x onerror=alert(1)>', /./],
};

/** Drops bytes as a file. */
const dropped = (studio, name, content) =>
  studio.page.evaluate(([name, content]) => {
    const data = new DataTransfer();
    data.items.add(new File([typeof content === 'string' ? content : Uint8Array.from(content)], name));
    document.querySelector('.orispline-studio').dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, content]);

test('what cannot be opened is told in a sentence; what is open stays, with its edits', async () => {
  const studio = await studioWith({ text: five });
  await studio.dragBy(studio.dot(2), 30, 0);
  const before = await studio.ask(({ store }) => store.current().document);
  for (const [what, [content, pattern]] of Object.entries(refused)) {
    const name = `<img src=x onerror="alert('${what}')">.csv`;
    await dropped(studio, name, content);
    const notice = studio.page.locator('.notice');
    await notice.waitFor();
    const text = await notice.locator('span').first().textContent();
    assert.match(text, wholeSentence, what);
    assert.match(text, pattern, what);
    assert.deepEqual(await studio.ask(({ store }) => store.current().document), before, what);
    await notice.getByRole('button', { name: 'Close this notice' }).click();
  }
  assert.equal(await studio.stepsBack(), 1);
  await studio.finish();
});

test('above the motion that the page opens with it is told too, one refusal in the place of the other, and the next file opens', async () => {
  const studio = await studioWith();
  const notice = studio.page.locator('.notice');
  for (const [what, [content, pattern]] of Object.entries(refused)) {
    await dropped(studio, `${what}.csv`, content);
    await studio.page.waitForFunction((what) => document.querySelector('.notice span')?.textContent.startsWith(what), what);
    const text = await notice.locator('span').first().textContent();
    assert.match(text, wholeSentence, what);
    assert.match(text, pattern, what);
    assert.doesNotMatch(text, /--|`/, what);
    assert.equal(await notice.count(), 1);
  }
  await studio.drop('good.csv', five);
  await studio.isOpen('good.csv');
  assert.equal(await notice.count(), 0);
  await studio.finish();
});

test('what the command writes into the page cannot end its script, nor can a name be markup', async () => {
  const name = '</script><img src=x onerror=alert(1)>.csv';
  const text = `# </script><script>alert(2)</script> <!--\n${five}`;
  const studio = await studioWith({ text, name });
  assert.equal(await studio.ask(({ original }) => original.text), text);
  assert.equal(await studio.page.locator('main img').count(), 0);
  await studio.dragBy(studio.dot(2), 30, 0);
  assert.match((await studio.download(() => studio.button('Save').click())).text, /^# <\/script>/);
  await studio.finish();
});

test('one key is opened with a sentence, and becomes two', async () => {
  const studio = await studioWith({ text: `${header}0,1,0,0,0\n` });
  await studio.notice(/one key/).waitFor();
  await studio.button('Duplicate key').click();
  await studio.drawn();
  assert.deepEqual(await studio.times(), [0, 1]);
  await studio.dot(2).focus();
  await studio.keyboard.press('ArrowRight');
  await studio.drawn();
  assert.equal(await studio.ask(({ store }) => store.current().troubles.first), null);
  await studio.keyboard.press('Control+z');
  await studio.keyboard.press('Control+z');
  await studio.drawn();
  assert.equal((await studio.keys()).length, 1);
  await studio.finish();
});

test('a recording of 100000 rows is reduced to keys, which are edited and saved', async () => {
  const rows = Array.from({ length: 1e5 }, (_, i) => `${i / 100},${Math.cos(Math.sin(i / 20000) / 2)},0,0,${Math.sin(Math.sin(i / 20000) / 2)}`);
  const studio = await studioWith({ text: five });
  await studio.drop('recording.csv', header + rows.join('\n'));
  const dialog = studio.dialog('Too many keys to edit');
  await dialog.waitFor();
  assert.match(await dialog.textContent(), /recording\.csv has 100000 keys; up to 1000 can be edited\./);
  const tolerance = dialog.getByRole('textbox', { name: 'Tolerance' });
  for (const wrong of ['much', '-1deg', '1/0', '']) {
    await tolerance.fill(wrong);
    await dialog.getByRole('button', { name: 'Reduce to keys' }).click();
    await studio.page.waitForFunction(() => document.querySelector('dialog .trouble')?.textContent);
    assert.match(await dialog.getByRole('alert').textContent(), wholeSentence);
  }
  await tolerance.fill('0.2deg');
  await dialog.getByRole('button', { name: 'Reduce to keys' }).click();
  await studio.isOpen('recording_keys.csv');
  const { length } = await studio.keys();
  assert.ok(length >= 2 && length < 100, length);
  await studio.dot(1).focus();
  await studio.keyboard.press(']');
  await studio.keyboard.press('ArrowRight');
  await studio.drawn();
  const { name, text } = await studio.download(() => studio.button('Save').click());
  assert.equal(name, 'recording_keys.csv');
  assert.equal(text.split('\n').filter((line) => /^[\d.]/.test(line)).length, length);
  await studio.finish();
});

test('letters, 1/0 and times that are a neighbour’s are refused at the field, and the key stays', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2' });
  await studio.dot(2).click();
  const before = await studio.ask(({ store }) => store.current().document);
  for (const name of ['time', 'Z, first turn', 'tension'])
    for (const wrong of ['letters', '1/0', '', '1e999', 'NaN']) {
      await studio.type(studio.field(name), wrong);
      assert.match(await studio.group('Key').getByRole('alert').textContent(), /^Found “.*”, wanted a number .*\.$/, `${name} ${wrong}`);
      await studio.field(name).press('Escape');
    }
  for (const neighbour of ['0', '2.5', '9', '-3']) {
    await studio.type(studio.field('time'), neighbour);
    assert.match(await studio.group('Key').getByRole('alert').textContent(), /wanted one between its neighbours.*\.$/, neighbour);
    await studio.field('time').press('Escape');
  }
  assert.deepEqual(await studio.ask(({ store }) => store.current().document), before);
  await studio.finish();
});

test('a method that refuses the keys says why; the last good curve stays in grey', async () => {
  const studio = await studioWith({ text: five, method: 'timed-c2', beside: 'slerp' });
  const shown = () => studio.ask(({ view }) => view.methods.map(({ name, failure, samples }) => [name, failure, samples.q.length]));
  const [[, , samples]] = await shown();
  await studio.method('Curve').selectOption('bezier');
  await studio.drawn();
  const refusal = studio.page.locator('.refusal.first');
  assert.match(await refusal.textContent(), /^bezier has no curve through these keys: bezier needs .*\. The last good one stays, in grey\.$/);
  const [[name, failure, kept]] = await shown();
  assert.deepEqual([name, kept], ['Curve timed-c2', samples]);
  assert.match(failure, /^bezier needs/);
  const colour = () => studio.ask(({ view }) => view.colours(view.current()).first);
  const grey = await colour();
  await studio.dragBy(studio.dot(2), 30, 0); // it is edited on
  await studio.drawn();
  await studio.method('Curve').selectOption('timed-c2');
  await studio.drawn();
  assert.equal(await refusal.isVisible(), false);
  assert.notEqual(await colour(), grey);
  await studio.finish();
});

test('without WebGL sentences stand for the scenes, and keys are edited by all else', async () => {
  const studio = await studioWith({ text: five }, { first: withoutGraphics });
  for (const name of ['Body', 'Sphere']) assert.match(await studio.group(name).textContent(), /no WebGL/);
  await studio.dragBy(studio.dot(2), 30, 0);
  await studio.dot(2).click();
  await studio.type(studio.field('X, third turn'), '15');
  await studio.drawn();
  assert.equal(await studio.stepsBack(), 2);
  await studio.finish();
});

/** In the worker too, whose text is in a blob. */
function withoutInstructions() {
  const Own = globalThis.Blob;
  globalThis.Blob = class extends Own {
    constructor(parts, options) {
      super(/javascript/.test(options?.type) ? ['WebAssembly.validate = () => false;', ...parts] : parts, options);
    }
  };
  WebAssembly.validate = () => false;
}

test('a browser whose WebAssembly has no SIMD is told which ones have', async () => {
  const studio = await studioWith({}, { first: withoutInstructions });
  const said = studio.page.locator('.notice span');
  await said.waitFor();
  const text = await said.textContent();
  assert.match(text, wholeSentence);
  assert.match(text, /SIMD/);
  assert.ok(text.includes(wanted), text);
  await studio.drop('keys.csv', five);
  await studio.page.waitForFunction(() => document.querySelector('.notice span').textContent.startsWith('keys.csv: found no WebAssembly with SIMD'));
  await studio.finish();
});

for (const [name, without] of Object.entries({
  popovers: () => delete HTMLElement.prototype.popover,
  'lists that are spliced into others': () => delete Array.prototype.toSpliced,
  'streams that unpack': () => delete globalThis.DecompressionStream,
}))
  test(`a browser without ${name} is told which ones have all that the page uses`, async () => {
    const context = await profile();
    const page = await context.newPage();
    const complaints = [];
    page.on('pageerror', ({ message }) => complaints.push(message));
    await page.addInitScript(without);
    await page.goto(pathToFileURL(process.env.ORISPLINE_STUDIO_PAGE).href);
    assert.equal(await page.locator('body').innerText(), `This browser is too old for the studio, which wants ${wanted}.`);
    assert.deepEqual(complaints, []);
    await context.close();
  });

test('the manual names the same browsers', () => {
  const manual = readFileSync(join(process.env.ORISPLINE_EXAMPLES, '../../docs/studio.md'), 'utf8').replace(/\s+/g, ' ');
  assert.ok(manual.includes(`${wanted} have all that it uses`), wanted);
});

const isFull = () => (Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); });
const isForbidden = () => Object.defineProperty(globalThis, 'localStorage', { get: () => { throw new DOMException('no', 'SecurityError'); } });
for (const [what, first, sentence] of [['full', isFull, /has no room left/], ['forbidden', isForbidden, /keeps nothing for this page/]])
  test(`storage that is ${what} is told once, and edits go on`, async () => {
    const studio = await studioWith({ text: five }, { first });
    await studio.dot(2).focus();
    await studio.keyboard.press('ArrowRight');
    await studio.notice(sentence).waitFor();
    await studio.keyboard.press('ArrowRight');
    assert.equal((await studio.times())[1], 1.1);
    assert.match((await studio.download(() => studio.button('Save').click())).text, /^1\.1,/m);
    assert.equal(await studio.page.locator('.notice.trouble').count() <= 1, true);
    await studio.finish();
  });

async function onDisk(options) {
  const studio = await studioWith({}, { first: withDisk, ...options });
  await studio.page.evaluate((text) => Object.assign(window, { disk: { 'disk.csv': text }, picked: 'disk.csv' }), five);
  await studio.button('Open a file…').click();
  await studio.isOpen('disk.csv');
  await studio.dot(2).focus();
  await studio.keyboard.press('ArrowRight');
  return studio;
}
const onceSaved = (studio) => studio.page.waitForFunction(() => window.studio.current.studio.store.current().isSaved);
const moved = five.replace('\n1,', '\n1.05,');

test('a file that was changed on the disk is not overwritten unasked', async () => {
  const studio = await onDisk();
  const disk = (name = 'disk.csv') => studio.page.evaluate((name) => window.disk[name], name);
  await studio.page.evaluate(() => (disk['disk.csv'] += '# by somebody else\n'));
  const changed = await disk();
  const dialog = studio.dialog('The file was changed');
  await studio.button('Save').click();
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await disk(), changed);
  assert.equal(await studio.ask(({ store }) => store.current().isSaved), false);
  await studio.page.evaluate(() => (picked = 'other.csv'));
  await studio.button('Save').click();
  await dialog.getByRole('button', { name: 'Save as another file' }).click();
  await onceSaved(studio);
  assert.deepEqual([await disk(), await disk('other.csv')], [changed, moved]);
  await studio.keyboard.press('Control+z');
  await studio.button('Save').click();
  await onceSaved(studio);
  assert.deepEqual([await disk(), await disk('other.csv')], [changed, five]);
  await studio.finish();
});

test('a changed file is overwritten when it is asked for, and a disk that refuses loses nothing', async () => {
  const studio = await onDisk();
  await studio.page.evaluate(() => (disk['disk.csv'] = 'gone'));
  await studio.button('Save').click();
  await studio.dialog('The file was changed').getByRole('button', { name: 'Overwrite' }).click();
  await onceSaved(studio);
  assert.equal(await studio.page.evaluate(() => disk['disk.csv']), moved);
  await studio.keyboard.press(']');
  await studio.button('Duplicate key').click();
  await studio.page.evaluate(() => (Blob.prototype.arrayBuffer = () => Promise.reject(new DOMException('The disk was taken away', 'NotFoundError'))));
  await studio.button('Save').click();
  await studio.dialog('The file was changed').getByRole('button', { name: 'Cancel' }).click();
  assert.equal((await studio.times()).length, 6);
  await studio.finish();
});

test('edits survive a reload, and two files from the disk do not mix', async () => {
  const within = await profile();
  const one = await studioWith({ text: five }, { within });
  await one.dot(2).focus();
  await one.keyboard.press('ArrowRight');
  await one.page.goto('about:blank');
  const other = await studioWith({ text: five.replace('\n5,', '\n6,') }, { within });
  assert.deepEqual(await other.times(), [0, 1, 2.5, 4, 6]);
  assert.equal(await other.page.locator('.notice').count(), 0);
  await other.dot(3).focus();
  await other.keyboard.press('ArrowRight');
  await other.page.goto('about:blank');
  const again = await studioWith({ text: five, name: 'renamed.csv' }, { within });
  assert.deepEqual(await again.times(), [0, 1.05, 2.5, 4, 5]);
  assert.equal(await again.ask(({ store }) => store.current().isSaved), false);
  await again.notice('Your edits of renamed.csv from before are here again.').waitFor();
  await again.page.reload();
  await again.isOpen('renamed.csv');
  assert.deepEqual(await again.times(), [0, 1.05, 2.5, 4, 5]);
  await again.button('Discard draft').click();
  assert.deepEqual(await again.times(), [0, 1, 2.5, 4, 5]);
  await again.page.goto('about:blank');
  const last = await studioWith({ text: five }, { within });
  assert.deepEqual(await last.times(), [0, 1, 2.5, 4, 5]);
  for (const page of [one, other, again, last]) await page.finish();
  await within.close();
});

test('a draft that is damaged is left alone', async () => {
  const within = await profile();
  const one = await studioWith({ text: five }, { within });
  const hash = await one.ask(({ original }) => original.hash);
  await one.page.evaluate((hash) => localStorage.setItem(`orispline-studio:${hash}`, '{"draft":1,"time":1,"document":{"version":1,"keys":[{}]}}'), hash);
  await one.page.reload();
  await one.isOpen('keys.csv');
  assert.deepEqual(await one.times(), [0, 1, 2.5, 4, 5]);
  await one.finish();
  await within.close();
});

const rows = (keys) => `${header}${keys.map((key) => key.join()).join('\n')}\n`;
const extremes = {
  'times of today': [rows([['1700000000.123456789', 1, 0, 0, 0], ['1700000001.5', 0.8, 0.6, 0, 0], ['1700000003', 0.6, 0, 0.8, 0]]), 3],
  'keys half a turn apart': [rows([[0, 1, 0, 0, 0], [1, 0, 1, 0, 0], [2, 0, 0, 1, 0], [3, 0, 0, 0, 1]]), 4],
  'two keys': [rows([[0, 1, 0, 0, 0], [1, 0.6, 0.8, 0, 0]]), 2],
  'a thousand keys': [rows(Array.from({ length: 1000 }, (_, i) => [i / 10, Math.cos(i / 300), 0, Math.sin(i / 300), 0])), 1000],
};
for (const [what, [text, count]] of Object.entries(extremes))
  test(`${what} are opened, edited, drawn and saved`, async () => {
    const studio = await studioWith({ text }, count > 100 ? { first: withoutGraphics } : {}); // a thousand axes take a computer without graphics seconds a frame
    assert.equal((await studio.keys()).length, count);
    await studio.dot(1).focus();
    await studio.keyboard.press(']');
    await studio.keyboard.press('Control+ArrowLeft');
    await studio.button('Table').click();
    await studio.keyboard.press('[');
    await studio.keyboard.press('i'); // at the time of a key there is no room
    await studio.notice(/no room/).waitFor();
    await studio.keyboard.press('Control+d');
    await studio.drawn();
    assert.equal(await studio.ask(({ store }) => store.current().troubles.first), null);
    const saved = (await studio.download(() => studio.button('Save').click())).text.split('\n');
    const [before] = [text.split('\n')];
    assert.equal(saved.length, before.length + 1);
    assert.equal(saved.filter((line) => !before.includes(line)).length, 2);
    assert.equal(await studio.stepsBack(), 2);
    await studio.finish();
  });

test('the page of a robot’s keys with positions is edited', async () => {
  const studio = await studioWith({ text: example('robot_keys.csv') });
  await studio.dot(3).click();
  await studio.type(studio.field('position x'), '0.5');
  await studio.drawn();
  assert.equal((await studio.keys())[2].p[0], 0.5);
  await studio.finish();
});
