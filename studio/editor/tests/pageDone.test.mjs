// SPDX-License-Identifier: Apache-2.0
// What the studio is for: a key is dragged, its tension pulled, undone, saved, and the motion made elsewhere, to the bit. The command is run; C++ where
// ORISPLINE_PREFIX is the installed library, Python where ORISPLINE_PYTHON has the package, JavaScript where ORISPLINE_NPM is the folder of its own.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { test } from 'node:test';
import { checkPlotted, columnsOf, columnsOfLists, state } from './plotted.mjs';
import { example, placeOf, studioWith } from './wholePage.mjs';

const save = (studio) => studio.download(() => studio.button('Save').click());

test('a key is dragged, its tension pulled, undone, saved: only its line is another one', async () => {
  const text = example('flight_keys.csv');
  const studio = await studioWith({ text, name: 'flight_keys.csv' });
  await studio.method('Curve').selectOption('timed-c2');
  await studio.dragBy(studio.dot(12), 9, 0);
  const dragged = (await studio.keys())[11];
  await studio.dragBy(studio.bar(12), 0, -12);
  assert.ok((await studio.keys())[11].own.tension > 0.5);
  await studio.button('Undo').click();
  const { name, text: saved } = await save(studio);
  assert.equal(name, 'flight_keys.csv');
  const [before, [stated, ...after]] = [text, saved].map((one) => one.split('\n'));
  assert.equal(stated, '# orispline: method=timed-c2'); // the file is opened with it again
  const changed = before.flatMap((line, i) => (line === after[i] ? [] : [i]));
  assert.equal(before.length, after.length);
  assert.equal(changed.length, 1);
  const [was, is] = [before, after].map((lines) => lines[changed[0]].split(','));
  assert.deepEqual(is.slice(1), was.slice(1));
  assert.equal(Number(is[0]), dragged.t);
  await studio.finish();
});

test('a file of Euler angles with dates, comments and further columns keeps all of them', async () => {
  const text = '# orispline: method=squad\n# degrees\ndate,yaw_deg,pitch_deg,roll_deg,speed,label\n2026-03-01T12:00:05+01:00,0,0,0,1.50,a\n2026-03-01T12:00:06+01:00,30,0,0,2,"b, c"\n2026-03-01T12:00:07.25+01:00,370,20,0,3,c\n'.replace('date,', 't,').replace('"b, c"', 'b');
  const studio = await studioWith({ text });
  assert.equal((await save(studio)).text, text);
  await studio.notice(/^keys\.csv is saved\.$/).waitFor();
  await studio.method('Curve').selectOption('timed-c2');
  await studio.drawn();
  const named = text.replace('=squad', '=timed-c2');
  assert.equal((await save(studio)).text, named);
  await studio.dot(2).focus();
  await studio.keyboard.press('ArrowRight');
  await studio.drawn();
  const moved = (await save(studio)).text.split('\n');
  assert.deepEqual(moved.toSpliced(4, 1), named.split('\n').toSpliced(4, 1));
  assert.match(moved[4], /^2026-03-01T12:00:06\.\d+\+01:00,30,0,0,2,b$/);
  await studio.dot(3).click();
  await studio.type(studio.field('X, third turn'), '12.5');
  await studio.drawn();
  const turned = (await save(studio)).text.split('\n');
  assert.deepEqual(turned.toSpliced(5, 1), moved.toSpliced(5, 1));
  assert.equal(turned[5], '2026-03-01T12:00:07.25+01:00,370,20,12.5,3,c');
  await studio.stepsBack();
  assert.equal((await save(studio)).text, text);
  await studio.finish();
});

test('where there is a column of tensions, a key that is dragged and pulled changes its line only', async () => {
  const studio = await studioWith();
  await studio.page.getByRole('button', { name: 'Tensions of a paper' }).click();
  await studio.isOpen('five_tensions.csv');
  const { text } = await studio.ask(({ original }) => original);
  await studio.dragBy(studio.dot(3), 25, 0);
  await studio.dragBy(studio.bar(3), 0, -10);
  const [, , { t, own }] = await studio.keys();
  const [stated, ...after] = (await save(studio)).text.split('\n');
  assert.equal(stated, '# orispline: method=quintic');
  const changed = text.split('\n').flatMap((line, i) => (line === after[i] ? [] : [after[i]]));
  assert.equal(changed.length, 1);
  assert.deepEqual([Number(changed[0].split(',')[0]), Number(changed[0].split(',').at(-1))], [t, own.tension]);
  await studio.finish();
});

/** What is plotted of a motion that was edited, its file, and what is copied of it. */
async function edited(given, edit) {
  const studio = await studioWith(given);
  await edit(studio);
  await studio.drawn();
  const plotted = await studio.ask(state);
  const { name, text } = await save(studio);
  const copied = {};
  for (const language of ['Command', 'C++', 'Python', 'JavaScript']) {
    await studio.button('Copy').click();
    await studio.page.getByRole('menuitem', { name: language }).click();
    const dialog = studio.dialog(new RegExp(`^${language.replaceAll('+', '\\+')} for`));
    copied[language] = await dialog.getByRole('textbox').inputValue();
    await studio.keyboard.press('Escape');
    await dialog.waitFor({ state: 'detached' });
  }
  const exported = {};
  for (const [item, title] of [['Samples', /^Samples/], ['Curve for the player', /player/]]) {
    await studio.button('Export').click();
    await studio.page.getByRole('menuitem', { name: item }).click();
    exported[item] = await studio.download(() => studio.dialog(title).getByRole('button', { name: 'Export' }).click());
  }
  await studio.finish();
  const folder = placeOf(`of ${name}`);
  mkdirSync(folder);
  writeFileSync(join(folder, name), text);
  return { plotted, copied, exported, folder, name };
}

const motions = [
  [
    { text: example('camera_keys.csv'), name: "it's a camera.csv", method: 'timed-c2' },
    async (studio) => {
      await studio.dragBy(studio.dot(1), 15, 0); // times count from it
      await studio.dragBy(studio.bar(4), 0, -9);
      await studio.button('Insert key').click();
    },
  ],
  [{ text: example('five_keys.csv'), name: 'five.csv', method: 'auto' }, (studio) => studio.dragBy(studio.dot(2), 20, 0)],
];
const made = [];
for (const [given, edit] of motions)
  test(`the motion of ${given.name} is edited, saved, copied and exported`, async () => {
    made.push(await edited(given, edit));
    const [{ plotted, exported }] = made.slice(-1);
    checkPlotted(plotted, columnsOf(exported.Samples.text), 'exported samples');
    assert.equal(exported.Samples.name, given.name.replace('.csv', '_samples.csv'));
    assert.ok(JSON.parse(exported['Curve for the player'].text));
  });

const path = [dirname(process.env.ORISPLINE_COMMAND), process.env.PATH].join(delimiter);

test('the command that is copied, as a shell runs it, gives the bits that were plotted', () => {
  for (const { plotted, copied, folder, name } of made) {
    execFileSync('sh', ['-c', copied.Command.replace(' -o ', ' --derivatives 3 -o ')], { cwd: folder, env: { ...process.env, PATH: path }, stdio: 'pipe' });
    checkPlotted(plotted, columnsOf(readFileSync(join(folder, 'motion.csv'), 'utf8')), name);
  }
});

const { ORISPLINE_NPM: npm, ORISPLINE_PYTHON: python, ORISPLINE_PREFIX: prefix } = process.env;

test('the JavaScript that is copied does', { skip: npm ? false : 'the npm package is not here; make web builds it' }, async () => {
  for (const { plotted, copied, folder, name } of made) {
    mkdirSync(join(folder, 'node_modules'));
    symlinkSync(npm, join(folder, 'node_modules/orispline'));
    const script = join(folder, 'copied.mjs');
    writeFileSync(script, `${copied.JavaScript}export { samples };\n`);
    const { orientations: q, angularVelocities: w, angularAccelerations: a, angularJerks: j, positions: p } = (await import(script)).samples;
    checkPlotted(plotted, columnsOfLists({ q, w, a, j, p }), name);
  }
});

const printed = `
import json
of = lambda name: None if getattr(samples, name, None) is None else getattr(samples, name).ravel().tolist()
print(json.dumps({"q": of("orientations"), "w": of("angular_velocities"), "a": of("angular_accelerations"), "j": of("angular_jerks"), "p": of("positions")}))
`;

test('the Python that is copied does', { skip: python ? false : 'the Python package is not here; make python builds it' }, () => {
  for (const { plotted, copied, folder, name } of made) {
    const script = join(folder, 'copied.py');
    writeFileSync(script, copied.Python + printed);
    checkPlotted(plotted, columnsOfLists(JSON.parse(execFileSync(python, [script], { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 26 }))), name);
  }
});

test('the C++ that is copied does', { skip: prefix ? false : 'the library is not installed; test package.install installs it' }, () => {
  const [{ plotted, copied, folder, name }] = made; // one is enough to compile
  const [source, program] = [join(folder, 'copied.cpp'), join(folder, 'copied')];
  writeFileSync(source, copied['C++']);
  const folders = ['lib', 'lib64', 'lib/x86_64-linux-gnu', 'lib/aarch64-linux-gnu'].map((one) => join(prefix, one, 'pkgconfig')).filter(existsSync);
  const env = { ...process.env, PKG_CONFIG_PATH: folders.join(delimiter) };
  const words = execFileSync('pkg-config', ['--cflags', '--libs', 'orispline'], { encoding: 'utf8', env }).trim().split(/\s+/);
  execFileSync('c++', ['-std=c++20', '-O0', source, '-o', program, ...words], { env });
  checkPlotted(plotted, columnsOf(execFileSync(program, { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 26 })), name);
});
