// SPDX-License-Identifier: Apache-2.0
// The screen of the studio, used in a browser, on an engine without a worker.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withoutGraphics } from '../../report/tests/browser.mjs';
import { opener } from './opener.mjs';
import { panelPage } from './panelPage.mjs';

const keys = 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2.5,0.6,0,0.8,0\n4,0,0,1,0\n5,0.6,0,0,0.8';
const opened = opener(panelPage);

/** Its scenes have tests of their own: here they would take most of the time of a computer that draws them by itself. */
async function studioOf(given = keys, { method = 'timed-c2', name = 'keys.csv', first = withoutGraphics, ...options } = {}) {
  const page = await opened({ first, ...options });
  await page.evaluate(([text, name, method]) => begin(text, name, { method }), [given, name, method]);
  await page.getByRole('group', { name: 'Time', exact: true }).waitFor();
  const state = (read) => page.evaluate(`(({ store, view }) => (${read})(store.current(), view.current()))(app.current.studio)`);
  return { page, state, close: page.finish, key: (n) => page.getByRole('slider', { name: `Key ${n}`, exact: true }), button: (name) => page.getByRole('button', { name, exact: true }) };
}

const centreOf = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 2, y + height / 2];
};

async function drag(page, locator, dx, dy) {
  const [x, y] = await centreOf(locator);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 5; ++step) await page.mouse.move(x + (dx * step) / 5, y + (dy * step) / 5);
  await page.mouse.up();
}

test('a key is dragged in time, never past its neighbour, in one step of the history; the time goes with it', async () => {
  const { page, state, key, button, close } = await studioOf();
  await drag(page, key(2), 60, 0);
  const [t, time] = await state('({ document }, { time }) => [document.keys[1].t, time]');
  assert.ok(t > 1.1 && t < 1.5, t);
  assert.equal(time, t);
  await drag(page, key(2), 2000, 0);
  const t2 = await state('({ document }) => document.keys[1].t');
  assert.ok(t2 < 2.35 && t2 > 2.25, t2); // both are seen
  await button('Undo').click();
  await button('Undo').click();
  assert.deepEqual(await state('({ document, canUndo }) => [document.keys[1].t, canUndo]'), [1, false]);
  await close();
});

test('the time goes with the last key beyond the end', async () => {
  const { page, state, key, close } = await studioOf();
  await key(5).focus();
  await page.evaluate(() => {
    const { draw } = engine;
    engine.draw = (document) => setTimeout(() => draw(document), 50); // curves come later than keys
  });
  for (const press of ['Shift+ArrowRight', 'Shift+ArrowRight', 'ArrowRight']) await page.keyboard.press(press);
  const [end, time] = await state('({ document }, { time }) => [document.keys[4].t, time]');
  assert.ok(end > 5.5);
  assert.equal(time, end);
  await page.waitForFunction((end) => app.current.studio.view.current().extent[1] === end, end);
  assert.equal(await state('(_, { time }) => time'), end);
  await close();
});

test('a key is deleted while it is dragged', async () => {
  const { page, state, key, close } = await studioOf();
  const [x, y] = await centreOf(key(2));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y);
  await page.keyboard.press('Delete');
  await page.mouse.move(x + 60, y);
  await page.mouse.up();
  assert.equal(await state('({ document }) => document.keys.map(({ t }) => t).join()'), '0,2.5,4,5');
  await close();
});

test('arrow keys move the key that has the focus, brackets choose another one, arrows elsewhere step the time', async () => {
  const { page, state, key, close } = await studioOf();
  await key(1).focus();
  await page.keyboard.press(']');
  assert.equal(await key(2).evaluate((one) => one === document.activeElement), true);
  await page.keyboard.press('ArrowRight');
  assert.equal(await state('({ document }) => document.keys[1].t'), 1.05);
  await page.keyboard.press('Shift+ArrowLeft');
  assert.equal(await state('({ document }) => document.keys[1].t'), 0.55);
  await page.keyboard.press('Control+ArrowRight');
  assert.equal(await state('({ document }) => document.keys[1].t'), 0.555);
  await page.getByRole('button', { name: 'Help' }).focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await state('(_, { time }) => Math.round(time * 1000)'), 605);
  await page.keyboard.press('[');
  assert.equal(await state('({ chosen }, { time }) => [chosen, time].join()'), '1,0');
  await page.keyboard.press('Control+z');
  assert.equal(await state('({ document }) => document.keys[1].t'), 0.55);
  await close();
});

test('a bar is pulled by mouse and by keys, and makes values of the keys’ own', async () => {
  const { page, state, button, close } = await studioOf();
  const bar = page.getByRole('slider', { name: 'tension of key 3' });
  await drag(page, bar, 0, -12);
  const own = await state('({ document }) => document.keys.map(({ own }) => own.tension)');
  assert.ok(own[2] > 0.6, String(own));
  assert.deepEqual(own.with(2, 0), [0.5, 0.5, 0, 0.5, 0.5]);
  await bar.focus();
  await page.keyboard.press('ArrowDown');
  assert.ok((await state('({ document }) => document.keys[2].own.tension')) < own[2]);
  await button('Undo').click();
  await button('Undo').click();
  assert.deepEqual(await state('({ document }) => document.keys[2].own'), {});
  const all = page.getByRole('slider', { name: 'All keys: tension' });
  await all.fill('0.7');
  assert.equal(await state('({ document }) => document.first.settings.tension'), 0.7);
  await close();
});

test('a key is inserted on the curve, duplicated and deleted; two are left at least', async () => {
  const { page, state, button, close } = await studioOf();
  const times = () => state('({ document }) => document.keys.map(({ t }) => t).join()');
  const [x, y] = await centreOf(page.getByRole('slider', { name: 'Key 1', exact: true }));
  await page.mouse.dblclick(x + 60, y);
  await page.getByRole('slider', { name: 'Key 6', exact: true }).waitFor();
  assert.equal(await state('({ document, chosen }) => document.keys[1].id === chosen'), true);
  await button('Duplicate key').click();
  assert.equal(await state('({ document }) => document.keys.length'), 7);
  await page.keyboard.press('Delete');
  await button('Undo').click();
  await button('Undo').click();
  await button('Undo').click();
  assert.equal(await times(), '0,1,2.5,4,5');
  for (let left = 4; left >= 2; --left) await button('Delete key').click();
  assert.equal(await button('Delete key').isDisabled(), true);
  assert.equal(await state('({ document }) => document.keys.length'), 2);
  await close();
});

test('numbers are typed in every form; what is none is refused by a sentence, and the value stays', async () => {
  const { page, state, close } = await studioOf();
  const panel = page.getByRole('group', { name: 'Key', exact: true });
  await page.keyboard.press(']');
  const field = (name) => panel.getByRole('textbox', { name, exact: true });
  for (const wrong of ['abc', '1/0', '']) {
    await field('time').fill(wrong);
    await field('time').press('Enter');
    assert.match(await panel.getByRole('alert').textContent(), /wanted a number/);
    assert.equal(await field('time').inputValue(), wrong);
  }
  await field('time').fill('2.5');
  await field('time').press('Enter');
  assert.match(await panel.getByRole('alert').textContent(), /neighbour/);
  await field('time').press('Escape');
  assert.equal(await field('time').inputValue(), '1');
  assert.equal(await state('({ canUndo }) => canUndo'), false);
  await field('Y, second turn').fill('30');
  await field('Y, second turn').press('Enter');
  await field('Z, first turn').fill('200');
  await field('Z, first turn').press('Enter');
  assert.equal(await field('Z, first turn').inputValue(), '200');
  await panel.getByRole('combobox', { name: 'Orientation as' }).selectOption('quaternion');
  assert.notEqual(await field('qz').inputValue(), '0');
  for (const name of ['qw', 'qx', 'qy']) {
    await field(name).fill('0');
    await field(name).press('Enter');
  }
  assert.deepEqual(await state('({ document }) => document.keys[1].q.map(Math.abs)'), [0, 0, 0, 1]);
  await field('qz').fill('0');
  await field('qz').press('Enter');
  assert.match(await panel.getByRole('alert').textContent(), /not all 0/);
  await close();
});

test('the table is the equal of the timeline', async () => {
  const { page, state, button, close } = await studioOf();
  await button('Table').click();
  const table = page.getByRole('group', { name: 'Keys', exact: true });
  assert.equal(await table.getByRole('row').count(), 6);
  await table.getByRole('textbox', { name: 'time of key 3' }).fill('3');
  await page.keyboard.press('Enter');
  assert.equal(await state('({ document, chosen }) => `${document.keys[2].t} ${chosen}`'), '3 3');
  await table.getByRole('textbox', { name: 'tension of key 3' }).fill('0.9');
  await page.keyboard.press('Enter');
  assert.equal(await state('({ document }) => document.keys[2].own.tension'), 0.9);
  await table.getByRole('button', { name: 'Key 5', exact: true }).click();
  assert.equal(await state('({ chosen }, { time }) => `${chosen} ${time}`'), '5 5');
  await close();
});

test('methods and their settings are made from what the library tells', async () => {
  const { page, state, button, close } = await studioOf();
  const settings = () => state('({ document }) => document.first.settings');
  await button('Settings of Curve').click();
  const form = page.getByRole('dialog', { name: 'Settings of Curve' });
  await form.getByRole('combobox', { name: 'End', exact: true }).selectOption('clamped');
  assert.deepEqual(await settings(), { ends: 'natural,clamped', end_rate: '0,0,0' });
  await form.getByRole('textbox', { name: /^End: angular velocity about z/ }).fill('0.5');
  await page.keyboard.press('Enter');
  assert.deepEqual(await settings(), { ends: 'natural,clamped', end_rate: '0,0,0.5' });
  await form.getByRole('checkbox', { name: 'Closed: a loop' }).check();
  assert.deepEqual(await settings(), { closed: true, period: 6.25 });
  await form.getByRole('checkbox', { name: 'Closed: a loop' }).uncheck();
  assert.deepEqual(await settings(), {});
  await page.keyboard.press('Escape');
  await page.getByRole('combobox', { name: 'Curve', exact: true }).selectOption('hermite-c1');
  await button('Settings of Curve').click();
  await form.getByRole('combobox', { name: 'stencil' }).selectOption('3');
  assert.deepEqual(await settings(), { stencil: '3' });
  await close();
});

test('a choice that is refused says why, and its last curve stays', async () => {
  const { page, state, close } = await studioOf();
  await page.getByRole('combobox', { name: 'Curve', exact: true }).selectOption('refused');
  await page.getByText('It refuses these keys.').waitFor();
  assert.equal(await state('(_, { first }) => first'), 'Curve timed-c2');
  await page.getByRole('combobox', { name: 'Curve', exact: true }).selectOption('auto');
  await page.waitForFunction(() => app.current.studio.view.current().first === 'Curve auto');
  assert.equal(await page.getByText('It refuses these keys.').count(), 0);
  await close();
});

test('what cannot be opened is one sentence, and what was open stays', async () => {
  const { page, state, close } = await studioOf();
  await page.keyboard.press(']');
  await page.evaluate(() => begin('no header', 'broken.csv'));
  await page.getByText('broken.csv: found no header').waitFor();
  assert.equal(await state('({ chosen }) => chosen'), 2);
  await page.evaluate(() => void begin(`t,qw,qx,qy,qz\n${Array.from({ length: 1200 }, (_, i) => `${i},1,0,0,0`).join('\n')}`, 'long.csv'));
  const dialog = page.getByRole('dialog', { name: 'Too many keys to edit' });
  await dialog.getByRole('textbox', { name: 'Tolerance' }).fill('much');
  await dialog.getByRole('button', { name: 'Reduce to keys' }).click();
  await page.getByText('wanted one such as 0.1deg').waitFor();
  await dialog.getByRole('textbox', { name: 'Tolerance' }).fill('0.5deg');
  await dialog.getByRole('button', { name: 'Reduce to keys' }).click();
  await page.getByRole('heading', { name: 'long_keys.csv' }).waitFor();
  assert.equal(await state('({ document }) => document.keys.length'), 12);
  await close();
});

/** In the page: a file of the disk, as a picker gives it. */
function fileOf(name, text) {
  const handle = { name, text, getFile: async () => new Blob([handle.text]), createWritable: async () => ({ write: async (bytes) => (handle.text = new TextDecoder().decode(bytes)), close: async () => {} }) };
  return handle;
}

test('keys are saved into the file that was opened, and a change on the disk is asked about', async () => {
  const { page, state, key, button, close } = await studioOf();
  await page.evaluate(`globalThis.fileOf = ${fileOf}; globalThis.disk = fileOf('disk.csv', ${JSON.stringify(keys)}); globalThis.showOpenFilePicker = async () => [disk];`);
  await button('Open').click();
  await page.getByRole('heading', { name: 'disk.csv' }).waitFor();
  await page.evaluate(() => (app.current.studio.original.hash = ''));
  await key(2).focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await state('({ isSaved }) => isSaved'), false);
  await page.keyboard.press('Control+s');
  const dialog = page.getByRole('dialog', { name: 'The file was changed' });
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await page.evaluate(() => disk.text), keys);
  await button('Save').click();
  await dialog.getByRole('button', { name: 'Overwrite' }).click();
  await page.getByText('disk.csv is saved.').waitFor();
  assert.equal(await page.evaluate(() => disk.text), keys.replace('\n1,0.8', '\n1.05,0.8'));
  assert.equal(await state('({ isSaved }) => isSaved'), true);
  await key(2).focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => app.current.studio.store.current().isSaved);
  assert.equal(await page.evaluate(() => disk.text), keys.replace('\n1,0.8', '\n1.1,0.8'));
  await close();
});

test('the keys of a recording are not written over it', async () => {
  const { page, button } = await studioOf();
  await page.evaluate(`globalThis.fileOf = ${fileOf}; globalThis.disk = fileOf('long.csv', 't,qw,qx,qy,qz\\n' + Array.from({ length: 1200 }, (_, i) => i + ',1,0,0,0').join('\\n')); globalThis.showOpenFilePicker = async () => [disk];`);
  const before = await page.evaluate(() => disk.text);
  await button('Open').click();
  await button('Reduce to keys').click();
  await page.getByRole('heading', { name: 'long_keys.csv' }).waitFor();
  const download = page.waitForEvent('download');
  await button('Save').click();
  assert.equal((await download).suggestedFilename(), 'long_keys.csv');
  assert.equal(await page.evaluate(() => disk.text), before);
  await page.close();
});

test('what is pasted while a question is open changes nothing', async () => {
  const { page, state, button, close } = await studioOf();
  await button('Copy').click();
  await page.getByRole('menuitem', { name: 'Command' }).click();
  await page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    document.querySelector('dialog h2').dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0,1,0,0');
  await page.keyboard.press('Escape');
  assert.equal(await state('({ document }) => document.keys.length'), 5);
  await page.getByRole('heading', { name: 'keys.csv' }).waitFor();
  await close();
});

test('a draft comes back, and is discarded', async () => {
  const { page, state, key, button, close } = await studioOf();
  await key(2).focus();
  await page.keyboard.press('ArrowRight');
  await page.evaluate((text) => begin(text, 'other.csv'), keys);
  await page.getByRole('heading', { name: 'other.csv' }).waitFor();
  await page.evaluate((text) => begin(text, 'keys.csv'), keys);
  await page.getByText('Your edits of keys.csv from before are here again.').waitFor();
  assert.equal(await state('({ document }) => document.keys[1].t'), 1.05);
  await button('Discard draft').click();
  assert.equal(await state('({ document }) => document.keys[1].t'), 1);
  await close();
});

test('files that are opened one after another leave nothing behind that listens', async () => {
  const { page, close } = await studioOf();
  await page.evaluate(() => {
    globalThis.listening = new Map([document, window].map((target) => [target, []]));
    for (const [target, heard] of listening) {
      const { addEventListener, removeEventListener } = target;
      target.addEventListener = (type, listener, ...more) => (heard.push([type, listener]), addEventListener.call(target, type, listener, ...more));
      target.removeEventListener = (type, listener, ...more) => {
        const place = heard.findIndex(([one, other]) => one === type && other === listener);
        if (place >= 0) heard.splice(place, 1);
        removeEventListener.call(target, type, listener, ...more);
      };
    }
  });
  const counts = [];
  for (const name of ['b.csv', 'c.csv', 'd.csv']) {
    await page.evaluate(([text, name]) => begin(text, name), [keys, name]);
    await page.getByRole('heading', { name }).waitFor();
    counts.push(await page.evaluate(() => [...listening.values()].flat().filter(([type]) => ['paste', 'keydown', 'pagehide'].includes(type)).length)); // plots have others, and are made later
  }
  assert.ok(counts[0] > 0 && counts.every((count) => count === counts[0]), counts.join());
  await close();
});

test('the command is copied out of a dialog', async () => {
  const { page, button, close } = await studioOf();
  await button('Copy').click();
  await page.getByRole('menuitem', { name: 'Command' }).click();
  const dialog = page.getByRole('dialog', { name: /^Command/ });
  assert.match(await dialog.getByRole('textbox').inputValue(), /^orispline sample keys.csv --method timed-c2/);
  await page.keyboard.press('Escape');
  await button('Copy').click();
  await page.getByRole('menuitem', { name: 'C++' }).click();
  await page.waitForFunction(() => {
    const area = document.querySelector('dialog textarea');
    return area === document.activeElement && area.scrollHeight > area.clientHeight && area.scrollTop === 0 && area.selectionEnd === area.value.length;
  });
  await page.keyboard.press('Escape');
  await close();
});
