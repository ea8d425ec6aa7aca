// SPDX-License-Identifier: Apache-2.0
// Files that cannot be read as they are, recordings with noise, files whose rows cannot stay, and what a reload keeps: on an engine without a worker.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withoutGraphics } from '../../report/tests/browser.mjs';
import { opener } from './opener.mjs';
import { panelPage } from './panelPage.mjs';

const five = 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2.5,0.6,0,0.8,0\n4,0,0,1,0\n5,0.6,0,0,0.8\n';
const opened = opener(panelPage);

async function pageOf(options = {}) {
  const page = await opened({ first: withoutGraphics, ...options });
  const give = (text, name = 'keys.csv', more = {}) => page.evaluate(([text, name, more]) => void begin(text, name, more), [text, name, more]);
  const isOpen = (name) => page.getByRole('heading', { name }).waitFor();
  const state = (read) => page.evaluate(`(({ store, view, original }) => (${read})(store.current(), view.current(), original))(app.current.studio)`);
  return { page, give, isOpen, state, close: page.finish, button: (name) => page.getByRole('button', { name, exact: true }), dialog: (name) => page.getByRole('dialog', { name }), notices: page.locator('.notice') };
}

test('a file without a frame rate is opened by a click, which is kept with it', async () => {
  const { page, give, isOpen, state, button, notices, close } = await pageOf();
  const frames = five.replace('t,', 'frame,');
  await give(frames);
  await notices.getByText('keys.csv:1: the column ’frame’'.replaceAll('’', "'")).waitFor();
  assert.equal(await notices.count(), 1);
  assert.doesNotMatch(await notices.textContent(), /--|`/);
  await button('24 frames/s').click();
  await isOpen('keys.csv');
  assert.deepEqual(await state('(state, view, { text, reading }) => [text, reading]'), [frames, { options: { fps: '24' }, comma: false }]);
  assert.equal(await notices.count(), 0);
  await give(frames, 'other.csv');
  await button('Other rate…').click();
  await page.getByRole('textbox', { name: 'Frames per second' }).fill('30000/1001');
  await button('Read it so').click();
  await isOpen('other.csv');
  assert.equal(await state('(state, view, { reading }) => reading.options.fps'), '30000/1001');
  await close();
});

test('a new refusal takes the place of the old one, and what is open stays with its edits', async () => {
  const { page, give, isOpen, state, button, dialog, notices, close } = await pageOf();
  await give('nothing', 'one.csv');
  await notices.getByText('one.csv: found no header').waitFor();
  await give(five.replace('t,', 'frame,'), 'two.csv');
  await notices.getByText('two.csv:1').waitFor();
  assert.equal(await notices.count(), 1);
  await give(five);
  await isOpen('keys.csv');
  await page.getByRole('slider', { name: 'Key 2', exact: true }).focus();
  await page.keyboard.press('ArrowRight');
  const before = await state('({ document }) => document');
  for (const [text, name] of [['nothing', 'one.csv'], [five.replace('t,', 'moment,'), 'two.csv']]) {
    await give(text, name);
    await notices.getByText(name).waitFor();
    assert.equal(await notices.count(), 1);
  }
  await button('Say which column is which…').click();
  await dialog('Which column is which').getByRole('button', { name: 'Cancel' }).click();
  assert.deepEqual(await state('({ document }) => document'), before);
  await button('Say which column is which…').click();
  const menu = (name) => dialog('Which column is which').getByRole('combobox', { name, exact: true });
  assert.deepEqual([await menu('qw').inputValue(), await menu('t').inputValue()], ['qw', '']);
  await menu('t').selectOption('moment');
  await button('Read it so').click();
  await isOpen('two.csv');
  assert.equal(await state('(state, view, { reading }) => reading.options.columns'), 't=moment,qw=qw,qx=qx,qy=qy,qz=qz');
  await close();
});

test('two rows of one time are mended in the text, of which all else stays; the file on the disk is still known', async () => {
  const { give, isOpen, state, button, close } = await pageOf();
  const twice = `# as measured\n${five.replace('2.5,', '1,0,1,0,0\n2.5,')}`;
  await give(twice);
  await button('Take out the later of the two rows').click();
  await isOpen('keys.csv');
  const [text, hash] = await state('(state, view, { text, hash }) => [text, hash]');
  assert.equal(text, twice.replace('1,0,1,0,0\n', ''));
  assert.match(hash, /^[0-9a-f]{64}$/);
  await close();
});

test('decimal commas are read by a click, and stay in the file', async () => {
  const { page, give, isOpen, state, button, close } = await pageOf();
  const commas = five.replaceAll(',', ';').replaceAll('.', ',');
  await give(commas);
  await button('Read commas as decimal points').click();
  await isOpen('keys.csv');
  assert.deepEqual(await state('({ document }) => document.keys[1].q'), [0.8, 0.6, 0, 0]);
  await page.getByRole('slider', { name: 'Key 2', exact: true }).focus();
  await page.keyboard.press('ArrowRight');
  const download = page.waitForEvent('download');
  await button('Save').click();
  const { createReadStream } = await import('node:fs'), parts = [];
  for await (const part of createReadStream(await (await download).path())) parts.push(part);
  assert.equal(Buffer.concat(parts).toString(), commas.replace('\n1;', '\n1,05;'));
  await close();
});

const recording = `t,qw,qx,qy,qz\n${Array.from({ length: 1280 }, (_, i) => `${i},1,0,0,0`).join('\n')}`;

test('reducing says which method it chose and why', async () => {
  const { give, isOpen, dialog, notices, button, close } = await pageOf();
  await give(recording, 'calm.csv');
  await dialog('Too many keys to edit').waitFor();
  await button('Reduce to keys').click();
  await isOpen('calm_keys.csv');
  await notices.getByText('These are 13 keys of auto, which needs the fewest (slerp 18). The curve is 0.099° from the recording at most.').waitFor();
  await close();
});

test('of a noisy recording nobody is given slerp unasked: the noise is named, and smoothing is offered first', async () => {
  const { page, give, isOpen, state, dialog, notices, button, close } = await pageOf();
  const question = dialog('Smooth the recording first?');
  const ask = async () => {
    await give(recording, 'noisy.csv');
    await button('Reduce to keys').click();
    await question.waitFor();
  };
  await ask();
  const said = await question.innerText();
  assert.match(said, /noisy\.csv has noise of about 0\.31° on each axis \(standard deviation\), which keys within 0\.1deg follow: it needs 640 keys of slerp, at each of which the rates jump\./);
  assert.match(said, /Smoothed first, it needs 13 keys of auto within 0\.1deg of the smoothed recording, 0\.33° from the samples as they were/);
  await question.getByRole('button', { name: 'Another tolerance' }).click();
  await dialog('Too many keys to edit').getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await dialog(/./).count(), 0);
  await ask();
  await question.getByRole('button', { name: 'Smooth first' }).click();
  await isOpen('noisy_keys.csv');
  assert.equal(await state('({ document }) => document.keys.length'), 13);
  await ask();
  assert.deepEqual(await question.getByRole('button').allTextContents(), ['Smooth first', 'Take the 645 keys of auto', 'Take the 640 keys of slerp', 'Another tolerance', 'Cancel']);
  await question.getByRole('button', { name: 'Take the 640 keys of slerp' }).click();
  await page.waitForFunction(() => app.current.studio.store.current().document.keys.length === 640);
  await give(five);
  await isOpen('keys.csv');
  await ask();
  await question.getByRole('button', { name: 'Take the 645 keys of auto' }).click();
  await notices.getByText('These are 645 keys of auto.').waitFor();
  await close();
});

test('reducing shows how far it is, and can be stopped', async () => {
  const { page, give, dialog, button, close } = await pageOf();
  await give(recording, 'slow.csv');
  await button('Reduce to keys').click();
  const waiting = dialog(/Looking for the keys/);
  await waiting.waitFor();
  assert.equal(await waiting.getByRole('progressbar').evaluate((bar) => bar.value), 0.25);
  await waiting.getByRole('button', { name: 'Stop' }).click();
  await dialog('Too many keys to edit').waitFor();
  assert.equal(await waiting.count(), 0);
  await page.keyboard.press('Escape');
  await dialog('Too many keys to edit').waitFor({ state: 'detached' });
  await close();
});

test('where rows cannot stay the page asks first, for another name', async () => {
  const { page, give, isOpen, state, dialog, button, close } = await pageOf();
  await give(five.replace('qw,qx,qy,qz', 'w,x,y,z'));
  await isOpen('keys.csv');
  await page.getByRole('slider', { name: 'Key 2', exact: true }).focus();
  await page.keyboard.press('ArrowRight');
  const question = dialog('keys.csv cannot keep its rows');
  await page.keyboard.press('Control+s');
  assert.match(await question.innerText(), /Comments and further columns of keys\.csv are not in that file\. keys\.csv itself stays as it is\./);
  await question.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await state('({ isSaved }) => isSaved'), false);
  await button('Save').click();
  const name = question.getByRole('textbox', { name: 'Name of the new file' });
  assert.equal(await name.inputValue(), 'keys_quaternions.csv');
  await name.fill('keys.csv');
  await question.getByRole('button', { name: 'Save as another file' }).click();
  await question.waitFor(); // not over itself
  await name.fill('edited');
  const [download] = await Promise.all([page.waitForEvent('download'), question.getByRole('button', { name: 'Save as another file' }).click()]);
  assert.equal(download.suggestedFilename(), 'edited.csv');
  await page.getByText('edited.csv is saved.').waitFor();
  await close();
});

test('the file, its steps and how it is looked at are there again after a reload', async () => {
  const { page, give, isOpen, state, button } = await pageOf();
  await give(five, 'mine.csv');
  await isOpen('mine.csv');
  await page.getByRole('slider', { name: 'Key 2', exact: true }).focus();
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('ArrowRight');
    await page.keyboard.up('ArrowRight');
  }
  await button('Undo').click();
  await page.evaluate(() => app.current.studio.view.choose({ body: 'camera', up: 'y', axis: 'z', theme: 'dark' }));
  const before = await state('({ document }) => document.keys.map(({ t }) => t)');
  await page.reload();
  await isOpen('mine.csv');
  assert.deepEqual(await state('({ document }) => document.keys.map(({ t }) => t)'), before);
  assert.deepEqual(await state('(state, { body, up, axis, theme }) => [body, up, axis, theme]'), ['camera', 'y', 'z', 'dark']);
  await button('Redo').click();
  while (await state('({ canUndo }) => canUndo')) await button('Undo').click();
  assert.deepEqual(await state('({ document }) => document.keys.map(({ t }) => t)'), [0, 1, 2.5, 4, 5]);
  assert.equal(await state('({ isSaved }) => isSaved'), true);
  await page.close();
});

test('Ctrl+O opens a file on the start screen, in a field, and where nothing is chosen', async () => {
  const { page, give, isOpen, close } = await pageOf();
  await page.evaluate((text) => {
    globalThis.picks = 0;
    globalThis.showOpenFilePicker = async () => [{ name: `picked ${++picks}.csv`, getFile: async () => new Blob([text.replace('\n5,', `\n${5 + picks},`)]) }];
  }, five);
  await page.keyboard.press('Control+o');
  await isOpen('picked 1.csv');
  await page.keyboard.press('Control+o');
  await isOpen('picked 2.csv');
  const field = page.getByRole('group', { name: 'Key', exact: true }).getByRole('textbox', { name: 'time', exact: true });
  await field.click();
  await page.keyboard.press('Control+o');
  await isOpen('picked 3.csv');
  await give(five);
  await close();
});
