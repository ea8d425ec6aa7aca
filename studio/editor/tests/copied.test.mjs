// SPDX-License-Identifier: Apache-2.0
// What is copied and exported, and what one may begin with. With ORISPLINE_COMMAND the command is run, with ORISPLINE_NPM the JavaScript.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { keysIn } from './library.mjs';
import { moduleOf, shoemake, timedC2 } from './modules.mjs';

const { copiedCode, languagesFor, samplesText, libraryText, templates } = await moduleOf('file/code.ts', 'file/exports.ts', 'document/templates.ts');

const folder = mkdtempSync(join(tmpdir(), 'orispline-copied-'));
after(() => rmSync(folder, { recursive: true }));

const command = process.env.ORISPLINE_COMMAND;
const packageFolder = process.env.ORISPLINE_NPM;
const needsCommand = { skip: command ? false : 'ORISPLINE_COMMAND is not set' };
const needsBoth = { skip: command && packageFolder ? false : 'ORISPLINE_COMMAND or ORISPLINE_NPM is not set' };

const cameraText = templates[1].text;
const wantedOf = (more = {}) => ({ name: 'keys.csv', keys: keysIn(cameraText), choice: { method: 'timed-c2', settings: { ends: 'rest' } }, method: { ...timedC2, rate_orders: 0 }, count: 101, ...more });
const tensions = templates.find(({ name }) => name === 'five_tensions.csv').text, withTensions = keysIn(tensions);

test('a command is one line that a shell reads as it is meant', () => {
  assert.equal(copiedCode('command', wantedOf()), 'orispline sample keys.csv --method timed-c2:ends=rest --count 101 -o motion.csv\n');
  assert.match(copiedCode('command', wantedOf({ name: "it's mine.csv" })), /^orispline sample 'it'\\''s mine\.csv' --method/);
  assert.match(copiedCode('command', wantedOf({ name: '-o.csv' })), /^orispline sample \.\/-o\.csv /);
  assert.match(copiedCode('command', wantedOf({ name: 'motion.csv' })), / -o samples\.csv\n$/);
});

/** What a shell makes of words, by the shell itself. */
const wordsOf = (text) => execFileSync('sh', ['-c', `printf '%s\\0' ${text.trim()}`], { encoding: 'utf8' }).split('\0').slice(0, -1);

test('names of any kind come through in every language', () => {
  for (const name of ['a b.csv', `"'.csv`, 'a\nb\t.csv', '$HOME `x` \\ !.csv', 'é ☃ \u2028.csv', '#;&|<>*?~.csv']) {
    assert.equal(wordsOf(copiedCode('command', wantedOf({ name })))[2], name);
    const written = /ori\.read\((".*"), scalar_first/s.exec(copiedCode('Python', wantedOf({ name })))[1];
    assert.equal(JSON.parse(written), name);
    const inC = /read_track\((".*"), \{/s.exec(copiedCode('C++', wantedOf({ name })))[1];
    assert.equal(inC.slice(1, -1).replace(/\\(?:([0-7]{3})|(.))/g, (_, code, c) => c ?? String.fromCharCode(Number.parseInt(code, 8))), name);
  }
});

test('programs name what the method reads of the keys', () => {
  assert.match(copiedCode('C++', wantedOf({ keys: withTensions })), /\{\.rate_orders = 0, \.parameters = \{"tension"\}\}/);
  assert.match(copiedCode('JavaScript', wantedOf({ keys: withTensions })), /, keys, \{ tension: \[0\.1, 0\.6, 0, 0\.6, 0\.1\] \}\);/);
  assert.doesNotMatch(copiedCode('JavaScript', wantedOf({ keys: withTensions, choice: { method: 'shoemake', settings: {} }, method: shoemake })), /tension/);
  for (const line of copiedCode('C++', wantedOf()).split('\n')) assert.equal(line.replace(/\\./g, '').split('"').length % 2, 1, line);
  assert.deepEqual(languagesFor(), ['command', 'C++', 'Python', 'JavaScript']);
  assert.deepEqual(languagesFor({ options: {}, comma: true }), ['JavaScript']);
  assert.deepEqual(languagesFor({ options: { fps: '24' }, comma: false }), ['command', 'Python', 'JavaScript']);
  for (const language of languagesFor()) assert.ok(copiedCode(language, wantedOf()).endsWith('\n'));
});

/** Rows of the file that the command writes, by the columns. */
function commanded(wanted, text) {
  writeFileSync(join(folder, wanted.name), text);
  const [, ...words] = wordsOf(copiedCode('command', wanted));
  execFileSync(command, [...words, '--derivatives', '3', '--quiet'], { cwd: folder });
  return readFileSync(join(folder, 'motion.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
}

const cases = [
  ['camera', wantedOf({ name: `"it's" a\ncamera.csv` }), cameraText],
  ['five', wantedOf({ name: 'five.csv', keys: withTensions, choice: { method: 'timed-c2', settings: { tension2: 0.9 } } }), tensions],
];

test('what the user has said of a file is in what is copied', () => {
  const reading = { options: { fps: '30000/1001', columns: 't=moment,qw=w', normalise: true }, comma: false }, wanted = { ...wantedOf(), reading };
  assert.match(copiedCode('command', wanted), / --fps 30000\/1001 --columns t=moment,qw=w --normalise --method /);
  assert.match(copiedCode('Python', wanted), /, fps="30000\/1001", columns=\{"t": "moment", "qw": "w"\}, normalise=True, scalar_first=True\)/);
});

test('the command that is copied writes so many samples', needsCommand, () => {
  for (const [, wanted, text] of cases) assert.equal(commanded(wanted, text).length, 102);
});

test('the JavaScript that is copied gives the bits of the command, and their export is its file', needsBoth, async () => {
  mkdirSync(join(folder, 'node_modules'));
  symlinkSync(packageFolder, join(folder, 'node_modules/orispline'));
  for (const [name, wanted, text] of cases) {
    const [header, ...rows] = commanded(wanted, text);
    const script = join(folder, `${name}.mjs`);
    writeFileSync(script, `${copiedCode('JavaScript', wanted)}export { samples };\n`);
    const { samples } = await import(script);
    const column = (names) => Float64Array.from(rows.flatMap((row) => names.map((one) => Number(row[header.indexOf(one)]))));
    assert.deepEqual(samples.orientations, column(['qw', 'qx', 'qy', 'qz']));
    assert.deepEqual(samples.angularJerks, column(['jx', 'jy', 'jz']));
    const { times: t, orientations: q, angularVelocities: w, angularAccelerations: a, angularJerks: j, positions: p = new Float64Array() } = samples;
    const isTold = header.map((one) => !/^(v|ap)[xyz]$/.test(one));
    const told = [header, ...rows].map((row) => row.filter((_, i) => isTold[i]).join());
    assert.equal(samplesText({ t, q, w, a, j, p }, '0'), `${told.join('\n')}\n`);
  }
});

test('samples are a table with exact times', () => {
  const none = new Float64Array();
  const samples = { t: Float64Array.of(0, 0.1), q: Float64Array.of(1, 0, 0, 0, 0.6, -0, 0.8, 1e-5), w: Float64Array.of(1, 2, 3, 4, 5, 6), a: none, j: none, p: none };
  assert.equal(samplesText(samples, '1700000000.000000001'), 't,qw,qx,qy,qz,wx,wy,wz\n1700000000.000000001,1,0,0,0,1,2,3\n1700000000.100000001,0.6,-0,0.8,1e-05,4,5,6\n');
  for (const [number, text] of [[1e16, '1e+16'], [123456789012345.6, '123456789012345.6'], [0.0001, '0.0001'], [-1.5e-300, '-1.5e-300'], [1e15, '1000000000000000']]) assert.equal(libraryText(number), text);
});

test('a template is a file that can be read, with methods and a sentence', () => {
  assert.deepEqual(templates.map(({ name }) => name), ['five_keys.csv', 'camera_keys.csv', 'flight_keys.csv', 'five_tensions.csv']);
  assert.deepEqual(templates.map(({ text, name }) => keysIn(text, name).length), [5, 12, 38, 5]);
  assert.deepEqual(withTensions.map(({ t, own }) => [t, own.tension]), [[0, 0.1], [1, 0.6], [2, 0], [3, 0.6], [4, 0.1]]);
  for (const { sentence, title } of templates) assert.match(`${title} ${sentence}`, /^[A-Z].*\.$/);
});
