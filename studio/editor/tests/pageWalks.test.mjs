// SPDX-License-Identifier: Apache-2.0
// Random walks through the built page: undo leads to where they began, and the file that is saved is what the command samples as it was plotted.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { withoutGraphics } from '../../report/tests/browser.mjs';
import { example, placeOf, studioWith, withDisk } from './wholePage.mjs';
import { checkPlotted, columnsOf, methodText, same, state } from './plotted.mjs';
import { walk } from './walk.mjs';

const [walks, edits] = [Number(process.env.ORISPLINE_WALKS ?? 2), 200];
const rowsOf = (text) => text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
const withTensions = rowsOf(example('five_keys.csv')).map((row, i) => `${row},${i === 0 ? 'tension' : (0.13 * i).toFixed(2)}`);
const files = {
  'five.csv': [example('five_keys.csv'), 'timed-c2'],
  'tensions.csv': [`# with\r\n${withTensions.join('\r\n')}\r\n`, 'quintic'],
  'camera.csv': [example('camera_keys.csv'), 'auto'],
  'flight.csv': [example('flight_keys.csv'), 'auto'],
  'late.csv': [`t;note;qw;qx;qy;qz\n1700000000.1;"a;b";1;0;0;0\n1700000001.3;;0.8;0.6;0;0\n# c\n1700000002.7;x;0.6;0;0.8;0\n1700000004;y;0;0;1;0`, 'auto'],
  'column.csv': [`stamp_ms,tension,x,qx,qy,qz,qw\n-500,0.5,1,0,0,0,1\n250,0.4,1,0.6,0,0,0.8\n1300,0.2,1,0,0.8,0,0.6\n1900,0.1,1,0,0,0.6,0.8\n2100,0.1,1,0.1,0.1,0.7,0.7\n`, 'timed-c2'],
};

/** What the command samples of a file, by columns; or why it does not. */
function commanded(name, text, method, count) {
  const file = placeOf(name);
  writeFileSync(file, text);
  try {
    const output = execFileSync(process.env.ORISPLINE_COMMAND, ['sample', file, '--method', method, '--count', String(count), '--derivatives', '3', '--quiet'], { encoding: 'utf8', stdio: 'pipe', maxBuffer: 2 ** 26 });
    return columnsOf(output);
  } catch ({ stderr }) {
    return { refused: stderr };
  }
}

function checkSaved(name, text, now) {
  const method = methodText(now.document.first);
  const told = commanded(name, text, method, now.count);
  if (now.troubles.first || told.refused) assert.ok(now.troubles.first && told.refused, `${method}: ${now.troubles.first?.message}, ${told.refused}`);
  else checkPlotted(now, told, `the command, ${name} with ${method}`);
}

/** As it is saved: with the method of A, where it is opened with another one than it names. */
const withMethod = (text, method) => (method === 'auto' ? text : `# orispline: method=${method}${/\r?\n/.exec(text)[0]}${text}`);

/** To run before a page: scenes that a computer draws without graphics take longer than all else, so that two files have them. */
const withoutScenes = `(${withDisk})(); (${withoutGraphics})();`;

/** A file of the disk that is open, and how it is saved. */
async function openedOnDisk(name, text, method, first) {
  const studio = await studioWith({}, { first, viewport: { width: 800, height: 600 } });
  await studio.page.evaluate(([name, text, method]) => {
    Object.assign(window, { disk: { [name]: text }, picked: name });
    return showOpenFilePicker().then(([handle]) => window.studio.open({ bytes: new TextEncoder().encode(text), name, method, handle }));
  }, [name, text, method]);
  await studio.isOpen(name);
  const saved = async () => {
    await studio.button('Save').click();
    await studio.page.waitForFunction(() => window.studio.current.studio.store.current().isSaved);
    return studio.page.evaluate((name) => disk[name], name);
  };
  return { studio, saved };
}

const walked = (studio, seed) => studio.page.evaluate(`(${walk})(${JSON.stringify({ seed, edits })})`);

for (const [number, [name, [text, method]]] of Object.entries(files).entries())
  test(`${walks} walks of ${edits} edits from ${name}`, async (context) => {
    const { studio, saved } = await openedOnDisk(name, text, method, number < 2 ? withDisk : withoutScenes);
    const began = await studio.ask(state);
    checkSaved(name, text, began);
    for (let i = 1; i <= walks; ++i) {
      const tried = await walked(studio, 1000 * number + i);
      await studio.drawn();
      const now = await studio.ask(state);
      checkSaved(name, await saved(), now);
      const steps = await studio.stepsBack();
      context.diagnostic(`${i}: ${steps} steps, ${now.document.keys.length} keys, ${methodText(now.document.first)}; ${JSON.stringify(tried)}`);
      await studio.drawn();
      const back = await studio.ask(state);
      assert.deepEqual(back.document, began.document);
      assert.ok(same(back.lists.q, began.lists.q));
      assert.equal(await saved(), withMethod(text, method));
    }
    await studio.finish();
  });

const turns = [[0, 0, 0], [30.5, 10, 0], [95, -20, 12.25], [190, 5, -170], [370, 0, 1]];
const others = {
  'angles.csv': `# degrees\r\nstamp;label;yaw_deg;pitch_deg;roll_deg;speed\r\n${turns.map((row, i) => `2026-03-01T12:00:0${2 * i}+01:00;row ${i};${row.join(';')};${i}.50`).join('\r\n')}\r\n`,
  'vectors.csv': `# of a tracker\nt,rx,ry,rz,px_mm,py_mm,pz_mm\n${turns.map((row, i) => [1.25 * i, ...row.map((angle) => (angle / 120).toFixed(4)), i, 2 * i, 0.5].join()).join('\n')}\n`,
};
for (const [number, [name, text]] of Object.entries(others).entries())
  test(`${walks} walks of ${edits} edits from ${name}, which has no quaternions, keep its form and end in its text`, async () => {
    const { studio, saved } = await openedOnDisk(name, text, 'auto', withoutScenes);
    for (let i = 1; i <= walks; ++i) {
      await walked(studio, 7000 + 100 * number + i);
      await studio.drawn();
      const header = text.split(/\r?\n/)[1], after = (await saved()).split(/\r?\n/);
      assert.ok(after.some((line) => line.startsWith(header)) && after.includes(text.split(/\r?\n/)[0]), after.join('\n'));
      await studio.stepsBack();
      await studio.drawn();
      assert.equal(await saved(), text);
    }
    await studio.finish();
  });
