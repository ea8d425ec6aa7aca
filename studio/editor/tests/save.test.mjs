// SPDX-License-Identifier: Apache-2.0
// What is saved: the text that was opened, with what was changed and nothing else.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { placeOf } from '../../pages.js';
import { fileEngine, keysIn } from './library.mjs';
import { dice, moduleOf, tension } from './modules.mjs';

const edits = ['turn', 'time', 'keys', 'position', 'parameters'].map((name) => `edits/${name}.ts`);
const { savedText, sameKeys, decimalOf, decimalText, quotient, sameMethod, methodText, dateIn, dateText, repaired, pointed, hasCommas, ...edit } = await moduleOf(
  'file/save.ts', 'file/dates.ts', 'file/repair.ts', 'document/methodText.ts', 'document/decimal.ts', 'document/reading.ts', ...edits,
);

const originalOf = (text, epoch, name = 'keys.csv') => ({ name, text, hash: 'abc', epoch });
const auto = { method: 'auto', settings: {} };
const documentIn = (text, first = auto, name = 'keys.csv') => ({ version: 1, keys: keysIn(text, name), first, second: { method: 'slerp', settings: {} } });
const example = (name) => readFileSync(placeOf(`../examples/data/${name}`), 'utf8');

/** Saves, and demands that the rows were kept. */
async function saved(text, epoch, change, { name = 'keys.csv', first = auto, opened = documentIn(text, first, name) } = {}) {
  const document = change(documentIn(text, first, name));
  const result = await savedText(originalOf(text, epoch, name), document, fileEngine(), opened);
  assert.equal(result.isWhole, false, result.text);
  assert.ok(sameKeys(keysIn(result.text, name), document.keys));
  return result.text;
}

const odd = [
  '\uFEFF# keys of a camera, "as they are"',
  '',
  'note,t,qw , qx,qy,qz,"px",py,pz,tension,frame',
  'a,10.50,1,0,0,0,0,0,0,0.5,1',
  '# between',
  '"b, c",11.0,  0.8,0.6,0,0,"1.0",0,0,0.25,2',
  'd,12.000000000000000001,0,1,0,0,2,0,0,0.5,3',
].join('\r\n');

/** What is asked of one that has no quotes with commas in them. */
const plain = odd.replace('"b, c"', 'b');

test('a text stays as it is, byte for byte, while no key is changed', async () => {
  for (const text of [odd.replace('"b, c"', '"b"'), `${plain}\r\n`, plain.replaceAll('\r\n', '\n'), example('five_keys.csv'), example('camera_keys.csv'), example('flight_keys.csv')]) {
    const epoch = text.includes('10.50') ? '10.5' : '0';
    assert.equal(await saved(text, epoch, (document) => document), text);
  }
});

test('a text of any form stays as it is while no key is changed, but for the line that names the method', async () => {
  const euler = '# orispline: method=slerp\n# a note\nt,yaw_deg,pitch_deg,roll_deg,mark\n5,0,0,0,a\n6,370,0,0,b\n';
  const turned = [[1, 0, 0, 0], [Math.cos(Math.PI / 36), 0, 0, Math.sin(Math.PI / 36)]];
  const keys = turned.map((q, i) => ({ id: i + 1, row: i, t: i, q, p: null, rates: [], own: {} }));
  const rowsOf = (text) => text.split('\n').slice(1).join('\n');
  const isOf = (text, { method }) => text.startsWith(`# orispline: method=${method}\n`);
  const engine = { ask: async (name, { text, choice }) => (name === 'reopens' ? isOf(text, choice) : name === 'read' && rowsOf(text) === rowsOf(euler) ? keys : 'anew') };
  const opened = { version: 1, keys, first: { method: 'slerp', settings: {} }, second: auto };
  const savedAs = (document) => savedText(originalOf(euler, '5'), document, engine, opened);
  assert.deepEqual(await savedAs(opened), { text: euler, isWhole: false });
  assert.deepEqual(await savedAs({ ...opened, second: opened.first, keys: keys.map((key) => ({ ...key })) }), { text: euler, isWhole: false });
  assert.deepEqual(await savedAs({ ...opened, first: auto }), { text: euler.replace('=slerp', '=auto'), isWhole: false });
  assert.deepEqual(await savedAs(edit.turnedTo(opened, 2, [0.6, 0.8, 0, 0])), { text: 'anew', isWhole: true });
});

test('of a key that is turned the four numbers of its quaternion are written', async () => {
  const text = await saved(plain, '10.5', (document) => edit.turnedTo(document, 2, [0.6, 0.8, 0, 0]));
  assert.equal(text, plain.replace('  0.8,0.6,0,0', '  0.6,0.8,0,0'));
});

test('of a key that is moved the time is written, exactly', async () => {
  const text = await saved(plain, '10.5', (document) => edit.movedInTime(document, 3, 1.7));
  assert.equal(text, plain.replace('12.000000000000000001', '12.2'));
  const first = await saved(plain, '10.5', (document) => edit.movedInTime(document, 1, -0.3));
  assert.equal(first, plain.replace('10.50', '10.2'));
  const late = plain.replace('10.50', '1700000000.000000001').replace('11.0', '1700000000.5').replace('12.000000000000000001', '1700000002');
  assert.equal(await saved(late, '1700000000.000000001', (document) => edit.movedInTime(document, 2, 0.75)), late.replace('1700000000.5', '1700000000.750000001'));
});

test('times are written in the unit of their column', async () => {
  const text = 't_ms,qw,qx,qy,qz\n1700000000000,1,0,0,0\n1700000000500,0.8,0.6,0,0\n1700000001000,0,1,0,0\n';
  assert.equal(await saved(text, '1700000000', (document) => edit.movedInTime(document, 2, 0.2505)), text.replace('1700000000500', '1700000000250.5'));
});

test('of a position and a value of its own the cell is written that was changed', async () => {
  const text = await saved(plain, '10.5', (document) => edit.withOwn(edit.placed(document, 2, 0, -3.5), 3, 'first', tension, 0.1));
  assert.equal(text, plain.replace('"1.0"', '"-3.5"').replace('2,0,0,0.5,3', '2,0,0,0.1,3'));
});

test('a new key is a row at its place, with empty cells where nothing is known', async () => {
  const text = await saved(plain, '10.5', (document) => edit.inserted(document, 0.25, { q: [1, 0, 0, 0], p: [0.5, 0, 0] }).document);
  assert.equal(text, plain.replace('# between', ',10.75,1,0,0,0,0.5,0,0,0.375,\r\n# between'));
  const copy = await saved(plain, '10.5', (document) => edit.duplicated(document, 3).document);
  assert.equal(copy, `${plain}\r\n,13,0,1,0,0,2,0,0,0.5,`);
  const before = await saved(`${plain}\r\n`, '10.5', (document) => edit.inserted(document, -1, { q: [1, 0, 0, 0], p: [0, 0, 0] }).document);
  assert.equal(before, `${plain.replace('a,10.50', ',9.5,1,0,0,0,0,0,0,0.5,\r\na,10.50')}\r\n`);
});

test('the row of a key that is deleted goes, and comments stay', async () => {
  const text = await saved(plain, '10.5', (document) => edit.deleted(document, 2));
  assert.equal(text, plain.replace(/"?b"?,11\.0.*\r\n/, ''));
  assert.equal(await saved(plain, '10.5', (document) => edit.deleted(document, 1)), plain.replace(/a,10\.50.*\r\n/, ''));
});

test('values of their own that are new are a column at the end, and those that are no more leave', async () => {
  const five = example('five_keys.csv');
  const text = await saved(five, '0', (document) => edit.withOwn(document, 2, 'first', tension, 0.25));
  assert.match(text, /\nt,qw,qx,qy,qz,tension\n0\.00,[^\n]*,0\.5\n1\.00,[^\n]*,0\.25\n/);
  assert.equal(await saved(text, '0', (document) => edit.withoutOwn(document, 'tension')), five);
  const without = await saved(plain, '10.5', (document) => edit.withoutOwn(document, 'tension'));
  assert.match(without, /"px",py,pz,frame\r\na,10\.50,1,0,0,0,0,0,0,1\r\n/);
});

test('TUM has blanks and no header', async () => {
  const tum = '# ground truth\n1.5 0 0 0 0 0 0 1\n2.5  1 0 0 0 0 0.6 0.8\n3.5 2 0 0 0 0 1 0\n';
  const how = { name: 'walk.tum' };
  const turned = await saved(tum, '1.5', (document) => edit.turnedTo(document, 2, [0.6, 0, 0, 0.8]), how);
  assert.equal(turned, tum.replace('0.6 0.8', '0.8 0.6'));
  const copy = await saved(tum, '1.5', (document) => edit.duplicated(document, 2).document, how);
  assert.equal(copy, tum.replace('3.5', '3  1  0  0  0  0  0.6  0.8\n3.5'));
});

test('rates of a new key are left free, those of a copy are written', async () => {
  const text = 't,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,0.5,0,0\n1,0.8,0.6,0,0,0.5,0,0\n2,0,1,0,0,0.5,0,0\n';
  assert.equal(await saved(text, '0', (document) => edit.inserted(document, 0.5, { q: [1, 0, 0, 0], p: null }).document), text.replace('1,0.8', '0.5,1,0,0,0,,,\n1,0.8'));
  assert.equal(await saved(text, '0', (document) => edit.duplicated(document, 1).document), text.replace('1,0.8', '0.5,1,0,0,0,0.5,0,0\n1,0.8'));
});

test('a file that is not simple is written anew, all of it, under a name that is asked for', async () => {
  const turn = (document) => edit.turnedTo(document, 2, [0.6, 0.8, 0, 0]);
  const document = turn(documentIn(plain));
  for (const text of [plain.replace(',qw ,', ',w,'), plain.replace(',t,', ',moment,'), plain.replace('# between', 'x,11,1,0,0,0,0,0,0,0,0'), 'no table', '']) {
    const engine = fileEngine();
    const ask = engine.ask.bind(engine);
    engine.ask = (name, given) => (name === 'read' ? Promise.resolve(keysIn(plain)) : ask(name, given));
    const { text: written, isWhole } = await savedText(originalOf(text, '10.5'), document, engine, documentIn(plain));
    assert.equal(isWhole, true, text);
    assert.equal(written, 'all 3 keys anew');
  }
});

test('what the library reads otherwise than it was meant is not saved so', async () => {
  const engine = fileEngine();
  let readings = 0;
  const ask = engine.ask.bind(engine);
  engine.ask = async (name, given) => {
    const told = await ask(name, given);
    return name === 'read' && ++readings === 2 ? told.map((key, i) => (i === 1 ? { ...key, t: key.t + Number.EPSILON } : key)) : told;
  };
  const { isWhole } = await savedText(originalOf(plain, '10.5'), edit.turnedTo(documentIn(plain), 2, [0.6, 0.8, 0, 0]), engine, documentIn(plain));
  assert.equal(isWhole, true);
  engine.ask = async (name, given) => (name === 'write' ? ask(name, given) : Promise.reject(new Error('not to be read')));
  assert.equal((await savedText(originalOf(plain, '10.5'), documentIn(plain), engine, documentIn(plain))).isWhole, true);
});

test('the comment that names the method is that of the curve, and is put there where the file would open with another one', async () => {
  const stated = (method) => `# one\n# orispline: method=${method} signs=shortest\nt,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n`;
  const first = { method: 'timed-c2', settings: { ends: 'rest', tension: 0.5 } };
  const same = (document) => document;
  const changed = (document) => ({ ...document, first });
  assert.equal(await saved(stated('slerp'), '0', same, { first: { method: 'slerp', settings: {} } }), stated('slerp'));
  assert.equal(await saved(stated('slerp'), '0', same, { first }), stated('timed-c2:ends=rest:tension=0.5'));
  assert.equal(await saved(stated('slerp'), '0', changed), stated('timed-c2:ends=rest:tension=0.5'));
  assert.equal(await saved(stated('timed-c2:tension=0.50:ends=rest'), '0', changed), stated('timed-c2:tension=0.50:ends=rest'));
  assert.equal(await saved(plain, '10.5', same), plain);
  const line = '# orispline: method=timed-c2:ends=rest\r\n', resting = (document) => ({ ...document, first: { method: 'timed-c2', settings: { ends: 'rest' } } });
  assert.equal(await saved(plain, '10.5', resting), plain.replace('\uFEFF', `\uFEFF${line}`));
  const gaps = (words) => `# orispline: ${words}\nt,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n`;
  assert.equal(await saved(gaps('gap=0.5'), '0', resting), gaps('method=timed-c2:ends=rest gap=0.5'));
  const tum = '1.5 0 0 0 0 0 0 1\n2.5  1 0 0 0 0 0.6 0.8\n';
  assert.equal(await saved(tum, '1.5', resting, { name: 'walk.tum' }), `# orispline: method=timed-c2:ends=rest\n${tum}`);
});

test('a column that a setting stands above stays; values from a list in the method become one when they are changed', async () => {
  const head = '# orispline: method=timed-c2:tension=0.5';
  const above = `${head}\n${plain.replaceAll('\r\n', '\n').slice(1)}`;
  const first = { method: 'timed-c2', settings: { tension: 0.5 } };
  const opened = documentIn(above, first);
  opened.keys.forEach((key) => (key.own = {}));
  const engine = fileEngine();
  const moved = await savedText(originalOf(above, '10.5'), edit.placed(opened, 3, 0, 7), engine, opened);
  assert.deepEqual(moved, { text: above.replace('2,0,0,0.5,3', '7,0,0,0.5,3'), isWhole: false });
  const pulled = await savedText(originalOf(above, '10.5'), edit.withOwn(opened, 2, 'first', tension, 0.75), engine, opened);
  assert.deepEqual(pulled, { text: above.replace('tension=0.5', '').replace('timed-c2:', 'timed-c2').replace('0,0,0.25,2', '0,0,0.75,2'), isWhole: false });

  const list = '# orispline: method=timed-c2:tension=0.1,0.2\nt,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n';
  const listed = documentIn(list, { method: 'timed-c2', settings: {} });
  listed.keys.forEach((key, i) => (key.own = { tension: [0.1, 0.2][i] }));
  const other = await savedText(originalOf(list, '0'), { ...listed, first: { method: 'timed-c2', settings: { ends: 'rest' } } }, engine, listed);
  assert.deepEqual(other, { text: '# orispline: method=timed-c2:ends=rest\nt,qw,qx,qy,qz,tension\n0,1,0,0,0,0.1\n1,0.8,0.6,0,0,0.2\n', isWhole: false });
  const turned = await savedText(originalOf(list, '0'), edit.turnedTo(listed, 2, [0.6, 0.8, 0, 0]), engine, listed);
  assert.deepEqual(turned, { text: list.replace('0.8,0.6', '0.6,0.8'), isWhole: false });
  const own = await savedText(originalOf(list, '0'), edit.withOwn(listed, 2, 'first', tension, 0.3), engine, listed);
  assert.deepEqual(own, { text: '# orispline: method=timed-c2\nt,qw,qx,qy,qz,tension\n0,1,0,0,0,0.1\n1,0.8,0.6,0,0,0.3\n', isWhole: false });
});

test('signs that say which way round to turn stay in the rows of other keys', async () => {
  const text = 't,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.8,0.6,0,0\n2,-0.6,0.8,0,0\n3,0,1,0,0\n';
  const given = documentIn(text);
  const signed = { ...given, keys: given.keys.map((key, i) => ({ ...key, q: [[1, 0, 0, 0], [-0.8, 0.6, 0, 0], [-0.6, 0.8, 0, 0], [0, 1, 0, 0]][i] })) };
  const { keys } = edit.turnedInWorld(signed, 3, [0.1, 0, 0]);
  assert.deepEqual(keys.toSpliced(2, 1), signed.keys.toSpliced(2, 1));
  assert.ok(keys[2].q[0] < 0);
});

test('texts of methods', () => {
  assert.equal(methodText({ method: 'timed-c2', settings: { tension: 0.6, ends: 'natural', closed: true } }), 'timed-c2:tension=0.6:ends=natural:closed');
  assert.equal(methodText({ method: 'auto', settings: { closed: false } }), 'auto');
  assert.ok(sameMethod('a:x=1.0:closed:ends=rest,natural', 'a:ends=rest,natural:closed:x=1'));
  assert.ok(!sameMethod('a:x=1', 'a:x=2'));
});

test('decimals are exact', () => {
  for (const [text, wanted] of [['1e-7', '0.0000001'], ['-0.50', '-0.5'], ['1.5e3', '1500'], ['0.0', '0'], ['-0', '0'], ['12.', '12'], ['.5', '0.5'], ['123456789012345678901234567890.123456789', '123456789012345678901234567890.123456789']])
    assert.equal(decimalText(decimalOf(text)), wanted);
  for (const text of ['', '.', 'e5', '1,5', '0x1', 'nan', '1e999999999']) assert.equal(decimalOf(text), null);
});

test('quotients have as many decimals as they are asked for', () => {
  for (const [one, other, wanted] of [['1', '24', '0.041666666666666667'], ['-1', '3', '-0.333333333333333333'], ['1001', '30000', '0.033366666666666667'], ['1e30', '4', '250000000000000000000000000000'], ['3', '1.5', '2']])
    assert.equal(decimalText(quotient(decimalOf(one), decimalOf(other), 18)), wanted);
});

test('dates are exact seconds, and are written as they were', () => {
  for (const [date, seconds] of [
    ['1970-01-01T00:00:00Z', '0'], ['2024-02-29T12:30:00.25Z', '1709209800.25'], ['2024-060T12:30:00.25', '1709209800.25'], ['2024-02-29 14:30:00.250+02:00', '1709209800.25'], ['2024-02-29T12:30', '1709209800'],
    ['2024-02-29', '1709164800'], ['1969-12-31T23:59:59.999999999Z', '-0.000000001'], ['0001-01-01T00:00:00Z', '-62135596800'], ['2026-03-01T12:00:00.123456789012-05:30', '1772386200.123456789012'],
  ]) {
    const found = dateIn(date);
    assert.equal(decimalText(found.seconds), seconds);
    assert.equal(dateText(found.seconds, found.style), date.replace(/(\.\d*?)0+(?=\D*$|[+-])/, '$1'));
  }
  for (const text of ['12', '2024', '2024-2-29', '2024-02-29T12', 'T12:00', '2024-02-29T12:30:00+2']) assert.equal(dateIn(text), null, text);
  const { style } = dateIn('2024-02-29');
  assert.equal(dateText(decimalOf('1709164800.5'), style), '2024-02-29T00:00:00.5');
  assert.equal(dateText(decimalOf('1e15'), style), null);
});

test('faults of a file are mended in its text, of which all else stays', () => {
  const head = '# a note\r\nlabel,t,qw,qx,qy,qz\r\n', rows = ['a,1,1,0,0,0\r\n', '# between\r\n', 'b,2.0,0.8,0.6,0,0\r\n', 'c,2,0.6,0.8,0,0\r\n', 'd,1.5,nan,1,0,0'], plainly = { options: {}, comma: false };
  const mended = (remedy, text = head + rows.join('')) => repaired(text, remedy, plainly);
  assert.equal(mended('drop_duplicates'), head + rows.toSpliced(3, 1).join(''));
  assert.equal(mended('drop_invalid'), head + rows.slice(0, 4).join('').trimEnd());
  assert.equal(mended('sort'), `${head}${rows[0]}${rows[1]}${rows[4]}\r\n${rows[2]}${rows[3].trimEnd()}`);
  assert.equal(mended('recipe', `# orispline: method\n${head}${rows[0]}`), head + rows[0]);
  for (const text of ['no table', 'a,b\n1,2\n']) assert.equal(mended('sort', text), null);
  const dated = 't;roll_deg;pitch_deg;yaw_deg\n2024-01-02;0,5;0;0\n2024-01-01;0;0;0\n';
  assert.equal(repaired(dated, 'sort', { options: {}, comma: true }), dated.replace(/(2024-01-02.*\n)(.*\n)/, '$2$1'));
});

test('decimal commas are points for the library, at the same places', () => {
  const text = '# at 0,5 s\nt;qw;note\n0,5;-1,25e-3;"1,5"\n1;2;a,b\n';
  assert.equal(pointed(text).length, text.length);
  assert.equal(pointed(text).split('\n').slice(1).join('\n'), 't;qw;note\n0.5;-1.25e-3;"1.5"\n1;2;a,b\n');
  assert.ok(hasCommas(text) && !hasCommas('t,qw\n0,1\n') && !hasCommas('t;qw\n0.5;1\n'));
});

test('thirty random walks: what is saved holds what was edited, and lines of untouched keys as they were', async () => {
  const camera = example('camera_keys.csv');
  for (let seed = 1; seed <= 30; seed++) {
    const random = dice(1000 + seed);
    const start = documentIn(camera);
    let document = start;
    for (let i = 0; i < 40; i++) {
      const { id, t } = document.keys[Math.floor(random() * document.keys.length)];
      const [a, b, c] = [random() - 0.5, random() - 0.5, random() - 0.5];
      const ways = [
        () => edit.turnedInWorld(document, id, [6 * a, 6 * b, 6 * c]),
        () => edit.movedInTime(document, id, t + a),
        () => edit.inserted(document, t + 2 * a, { q: [a, b, c, 1], p: [a, b, c] }).document,
        () => edit.duplicated(document, id).document,
        () => edit.deleted(document, id),
        () => edit.placed(document, id, 1, 10 * a),
        () => edit.withOwn(document, id, 'first', tension, 2 * a),
        () => edit.withoutOwn(document, 'tension'),
      ];
      document = ways[Math.floor(random() ** 0.8 * ways.length)]();
    }
    const { text, isWhole } = await savedText(originalOf(camera, '0'), document, fileEngine(), start);
    assert.equal(isWhole, false, `seed ${seed}`);
    assert.ok(sameKeys(keysIn(text), document.keys), `seed ${seed}`);
    const lines = new Set(text.split('\n').map((line) => line.split(',').slice(0, 8).join()));
    const rows = camera.split('\n').filter((line) => /^\d/.test(line));
    for (const key of document.keys) {
      const before = key.row === null ? undefined : start.keys[key.row];
      const stays = before && key !== document.keys[0] && key.t === before.t && key.p === before.p && (key.q === before.q || key.q.every((number, i) => number === -before.q[i]));
      if (stays) assert.ok(lines.has(rows[key.row]), `seed ${seed}: ${rows[key.row]}`);
    }
    for (const line of camera.split('\n').filter((other) => other.startsWith('#'))) assert.ok(text.includes(`${line}\n`));
  }
});
