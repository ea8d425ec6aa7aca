// SPDX-License-Identifier: Apache-2.0
// What the engine answers, beside the command.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { answers, bytesOf, command, engine, example, module, plain, sampled } from './engine.mjs';

const ask = answers(), methods = JSON.parse(command('methods', '--json'));
const folder = mkdtempSync(join(tmpdir(), 'orispline-engine-'));
after(() => rmSync(folder, { recursive: true }));

const opened = (name, more = {}) => ask.open({ bytes: readFileSync(example(name)), name, ...more });
const openedText = (text, more = {}) => ask.open({ bytes: bytesOf(text), name: 'keys.csv', ...more });
const file = (text) => (writeFileSync(join(folder, 'keys.csv'), text), join(folder, 'keys.csv'));
const troubleOf = (call) => {
  try {
    call();
  } catch ({ message, line, column, key, option }) {
    return { message, line, column, key, option };
  }
  return null;
};

/** The samples of a curve without those on the left of keys. */
function rightSides({ t, q, w, a, j, p }) {
  const kept = [...t.keys()].filter((k) => t[k] !== t[k + 1]);
  const rows = (numbers, width) => (numbers.length ? kept.flatMap((k) => [...numbers.subarray(width * k, width * (k + 1))]) : []);
  return { t: kept.map((k) => t[k]), q: rows(q, 4), w: rows(w, 3), a: rows(a, 3), j: rows(j, 3), p: rows(p, 3) };
}

test('the methods are those of the command', () => {
  assert.deepEqual(ask.methods(null), methods);
});

for (const name of ['five_keys.csv', 'flight_keys.csv'])
  for (const { name: method } of methods)
    test(`${method} through ${name} has the bits of the command, or its refusal`, () => {
      const { document } = opened(name, { method }), { first } = answers().curves({ document, count: 61 });
      if (first.trouble) {
        assert.throws(() => sampled(example(name), method, 61), ({ stderr }) => stderr.replace(/\s+/g, ' ').includes(first.trouble.message.replace(/^key \d+: /, '')));
        return;
      }
      const wanted = sampled(example(name), method, 61);
      assert.deepEqual(plain(ask.sample({ keys: document.keys, choice: document.first, count: 61, rates: 3 })), wanted);
      const inner = document.keys.map(({ t }) => t).filter((t) => wanted.t[0] < t && t < wanted.t.at(-1)), right = rightSides(first);
      assert.deepEqual(right.t, [...new Set([...wanted.t, ...inner])].sort((a, b) => a - b));
      wanted.t.forEach((t, k) => assert.deepEqual(right.q.slice(4 * right.t.indexOf(t), 4 * right.t.indexOf(t) + 4), wanted.q.slice(4 * k, 4 * k + 4)));
      assert.equal(first.t.length, right.t.length + inner.length);
      assert.equal(first.orders.length, document.keys.length);
    });

test('both sides of a key are drawn, and which order is reached there', () => {
  const { document } = opened('five_keys.csv', { method: 'slerp', beside: 'timed-c2' }), { first, second } = answers().curves({ document, count: 10 });
  assert.deepEqual([...first.orders], [3, 0, 0, 0, 3]);
  assert.deepEqual([...second.orders], [3, 2, 2, 2, 3]);
  const at = first.t.indexOf(1.5);
  assert.equal(first.t[at + 1], 1.5);
  assert.notEqual(first.w[3 * at], first.w[3 * at + 3]);
});

test('the last double before a time is its neighbour', () => {
  for (const [time, wanted] of [[1, 1 - Number.EPSILON / 2], [2, 2 - Number.EPSILON], [0, -Number.MIN_VALUE], [-1, -1 - Number.EPSILON], [0.1, 0.09999999999999999]]) assert.equal(engine.before(time), wanted);
});

test('even times are those of the command, whatever they begin with', () => {
  for (const times of [[0.1, 0.3, 1.7], [-1e-3, 0, 1 / 3], [123456.789, 123457, 123458.123], [1e-9, 2e-9, 7e-9]]) {
    const path = file(`t,qw,qx,qy,qz\n${times.map((t) => `${t},1,0,0,0`).join('\n')}\n`);
    for (const count of [1, 2, 97]) assert.deepEqual([...engine.evenTimes(times[0], times[2], count)], sampled(path, 'slerp', count).t);
  }
});

test('a choice that has not changed is not drawn again', () => {
  const ours = answers(), { document } = opened('five_keys.csv', { method: 'timed-c2' });
  assert.ok(ours.curves({ document, count: 10 }).second.t);
  const again = ours.curves({ document: { ...document, first: { ...document.first, settings: { tension: 0.5 } } }, count: 10 });
  assert.ok(again.first.t);
  assert.equal(again.second, 'same');
  const own = { ...document, keys: document.keys.map((key, k) => ({ ...key, own: { tension: k / 4 } })) }, pulled = ours.curves({ document: own, count: 10 });
  assert.ok(pulled.first.t);
  assert.equal(pulled.second, 'same');
  const turned = { ...own, keys: own.keys.map((key, k) => (k === 2 ? { ...key, q: [1, 0, 0, 0] } : key)) };
  assert.ok(ours.curves({ document: turned, count: 10 }).second.t);
});

test('columns of parameters are values of the keys, with the bits of the command', () => {
  const tensions = [0.5, 0.25, 1, 0.75, 0.3], rows = readFileSync(example('five_keys.csv'), 'utf8').trim().split('\n').filter((row) => /^\d/.test(row));
  const text = `# orispline: method=timed-c2:ends=natural\nt,qw,qx,qy,qz,tension,note\n${rows.map((row, k) => `${row},${tensions[k]},7`).join('\n')}\n`;
  const { document } = openedText(text), wanted = sampled(file(text), 'timed-c2:ends=natural', 50);
  assert.deepEqual(document.keys.map(({ own }) => own), tensions.map((tension) => ({ tension })));
  assert.deepEqual(document.first, { method: 'timed-c2', settings: { ends: 'natural' } });
  assert.deepEqual(document.second, { method: 'slerp', settings: {} });
  assert.deepEqual(plain(ask.sample({ keys: document.keys, choice: document.first, count: 50, rates: 3 })), wanted);
  const listed = opened('five_keys.csv', { method: `timed-c2:ends=natural:tension=${tensions}` }).document;
  assert.deepEqual([listed.first, listed.keys.map(({ own }) => own)], [document.first, document.keys.map(({ own }) => own)]);
  assert.deepEqual(openedText(text, { method: 'timed-c2:tension=0.5' }).document.keys[0].own, {});
});

test('what was opened is kept as it was', () => {
  const { original, document, warnings } = opened('flight_keys.csv'), bytes = readFileSync(example('flight_keys.csv'));
  assert.deepEqual(original, { name: 'flight_keys.csv', text: bytes.toString('utf8'), hash: createHash('sha256').update(bytes).digest('hex'), epoch: '0' });
  assert.deepEqual([document.version, document.keys.length, document.keys[7].row, document.keys[7].p.length, warnings], [1, 38, 7, 3, []]);
  assert.deepEqual([opened('five_keys.csv').document.first.method, opened('five_keys.csv', { method: 'slerp' }).document.second.method], ['auto', 'auto']);
  for (const length of [0, 1, 55, 56, 63, 64, 119, 120, 1000]) {
    const some = Uint8Array.from({ length }, (_, k) => (k * k) % 251);
    assert.equal(engine.sha256(some), createHash('sha256').update(some).digest('hex'));
  }
});

test('bad files are refused with the sentence of the library and its place', () => {
  const nan = troubleOf(() => openedText('t,qw,qx,qy,qz\n0,1,0,0,0\n1,nan,0,0,0\n'));
  assert.deepEqual([nan.line, nan.column], [3, 2]);
  assert.match(troubleOf(() => openedText('t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n')).message, /duplicate time 0/);
  for (const text of ['', 'no header\n1,2\n', 't,qw,qx,qy,qz\n0,0,0,0,0\n', 't,qw,qx,qy,qz\n']) assert.ok(troubleOf(() => openedText(text)).message.length > 10, text);
  const wide = new Uint8Array(new Uint16Array([...'\uFEFFt,qw,qx,qy,qz\n0,1,0,0,0\n'].map((letter) => letter.charCodeAt(0))).buffer);
  assert.match(troubleOf(() => ask.open({ bytes: wide, name: 'keys.csv' })).message, /UTF-16/);
  assert.ok(troubleOf(() => ask.open({ bytes: Uint8Array.from({ length: 500 }, (_, k) => (k * 7919) % 256), name: 'keys.csv' })).message);
  assert.match(troubleOf(() => opened('five_keys.csv', { method: 'slurp' })).message, /did you mean 'slerp'/);
  assert.match(openedText('t,qw,qx,qy,qz\n0,1,0,0,0\n').warnings[0].message, /one key/);
  assert.match(openedText('# orispline: method=slerp signs=as-given\nt,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.8,0.6,0,0\n').warnings[0].message, /short way/);
});

test('a method that refuses the keys says why, and the other one is drawn', () => {
  const { document } = opened('five_keys.csv', { method: 'timed-c2' });
  const { first, second } = answers().curves({ document: { ...document, first: { method: 'timed-c2', settings: { ends: 'x' } } }, count: 10 });
  assert.equal(first.trouble.option, 'ends');
  assert.match(first.trouble.message, /unknown end rule 'x'/);
  assert.ok(second.t.length > 10);
});

test('a recording with too many rows says so, and is reduced', () => {
  const bytes = readFileSync(example('flight_truth.csv')), name = 'flight_truth.csv', found = ask.open({ bytes, name });
  assert.ok(found.count > 1000 && !found.document && found.original.text && found.hasPositions);
  const shares = [], reduced = ask.reduce({ bytes, name, tolerance: '0.5deg' }, (share) => shares.push(share)), { original, document, warnings } = reduced.opened;
  assert.deepEqual([original.name, original.text, document.keys[3].row, warnings], ['flight_truth_keys.csv', '', null, []]);
  assert.ok(shares.length > 0 && shares.every((share) => share >= 0 && share <= 1), String(shares));
  const wanted = JSON.parse(command('reduce', example(name), '--tolerance', '0.5deg', '--json', '--quiet', '-o', join(folder, 'reduced.csv')));
  assert.deepEqual([reduced.count, reduced.method, reduced.furthest, reduced.furthestPosition], [wanted.keys, wanted.method, wanted.error_max_deg, wanted.position_error_max_m]);
  assert.deepEqual(reduced.others.map(({ method, count }) => [method, count]), wanted.methods.filter(({ method }) => method !== wanted.method).map(({ method, keys }) => [method, keys]));
  assert.ok(answers().curves({ document, count: 100 }).first.t);
  assert.match(troubleOf(() => ask.reduce({ bytes, name, tolerance: '0.5' })).message, /0\.5/);
});

test('noise is named, and smoothed first where that is asked for', () => {
  let state = 1;
  const noise = () => ((state = (state * 16807) % 2147483647) / 2147483647 - 0.5) * 0.02;
  const rows = Array.from({ length: 1500 }, (_, i) => `${i / 100},${Math.cos(i / 500)},${noise()},${noise()},${Math.sin(i / 500)}`);
  const given = { bytes: bytesOf(`t,qw,qx,qy,qz\n${rows.join('\n')}\n`), name: 'noisy.csv', tolerance: '0.3deg' };
  const raw = ask.reduce(given), smoothed = ask.reduce({ ...given, smooth: true });
  assert.equal(raw.smoothed, null);
  assert.ok(smoothed.count < raw.count / 5, `${smoothed.count} of ${raw.count}`);
  const sigma = ((0.02 / Math.sqrt(12)) * 2 * 180) / Math.PI; // of the rotation vector, of which the quaternion has half
  assert.ok(smoothed.smoothed.noise > 0.5 * sigma && smoothed.smoothed.noise < 1.5 * sigma, `${smoothed.smoothed.noise}, ${sigma}`);
  assert.equal(ask.reduce({ ...given, smooth: true, methods: 'auto,timed-c2' }).others.some(({ method }) => method === 'slerp'), false);
});

test('keys that are written are read again, with the epoch and the method', () => {
  const { document } = opened('flight_keys.csv', { method: 'timed-c2:tension=0.75' });
  const text = ask.write({ keys: document.keys, epoch: '1700000000.1', name: 'out.csv', choice: document.first });
  assert.match(text, /^# orispline: method=timed-c2:tension=0.75\n/);
  const again = ask.read({ text, name: 'out.csv' });
  assert.deepEqual(again.map(({ t, q, p }) => [t, q, p]), document.keys.map(({ t, q, p }) => [t, q, p]));
  assert.equal(openedText(text).original.epoch, '1700000000.1');
  const rates = document.keys.map((key, k) => ({ ...key, rates: [k ? [0, 0.1, 0] : [NaN, NaN, NaN]], own: { tension: 0.5 } }));
  const kept = ask.read({ text: ask.write({ keys: rates, epoch: '0', name: 'out.csv', choice: null }), name: 'out.csv' });
  assert.deepEqual(kept.map((key) => [key.rates, key.own]), rates.map((key) => [key.rates, key.own]));
});

test('a fault ends one answer, and no other', () => {
  const answering = new engine.Answering(module), { document } = answering.answer('open', { bytes: readFileSync(example('five_keys.csv')), name: 'five_keys.csv' });
  assert.ok(answering.answer('curves', { document, count: 10 }).first.t);
  answering.library.engine.fault = new Error('a fault');
  assert.throws(() => answering.answer('at', { keys: document.keys, choice: document.first, time: 1 }), /a fault/);
  const { first, second } = answering.answer('curves', { document, count: 10 });
  assert.ok(first.t && second.t);
});

test('one time, and what is baked', () => {
  const { document } = opened('flight_keys.csv'), { keys, first: choice } = document;
  const { q, p } = ask.at({ keys, choice, time: keys[4].t });
  assert.ok(q.every((x, i) => Math.abs(x - keys[4].q[i]) < 1e-12) && p.every((x, i) => Math.abs(x - keys[4].p[i]) < 1e-9));
  assert.equal(ask.at({ ...opened('five_keys.csv').document, choice, time: 1 }).p, null);
  assert.equal(JSON.parse(ask.bake({ keys, choice, tolerance: 1e-4 })).orispline, 'baked');
});

/** What is said of a text, and what would mend it. */
function saidOf(text, name = 'keys.csv', reading) {
  try {
    const { warnings } = ask.open({ bytes: bytesOf(text), name, ...(reading ? { reading } : {}) });
    return { message: warnings.map(({ message }) => message).join(), remedy: warnings.find(({ remedy }) => remedy)?.remedy };
  } catch (reason) {
    return engine.troubleOf(reason);
  }
}

test('where the library names an option the page says what can be done, and opens the file so', () => {
  const row = 't,qw,qx,qy,qz\n';
  const cures = [
    ['0,1,0,0,0\n1,1,0,0,0\n', 'order', { order: 'wxyz' }], ['t,roll,pitch,yaw\n1,1,0,0\n2,1,0,0\n', 'angle_unit', { angle_unit: 'deg' }],
    ['t,e1_deg,e2_deg,e3_deg\n1,1,0,0\n2,1,0,0\n', 'euler', { euler: 'ZXZ' }], ['frame,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n', 'fps', { fps: '24' }],
    ['moment,w,x,y,z\n0,1,0,0,0\n1,1,0,0,0\n', 'columns', { columns: 't=moment,qw=w,qx=x,qy=y,qz=z' }], [`${row}1,1,0,0,0\n0,1,0,0,0\n`, 'sort', { sort: true }],
    [`${row}1,1,0,0,0\n1,1,0,0,0\n`, 'drop_duplicates', { drop_duplicates: true }], [`${row}0,1,0,0,3\n1,1,0,0,0\n`, 'normalise', { normalise: true }],
    [`${row}0,1,0,0,0\n1,nan,0,0,0\n`, 'drop_invalid', { drop_invalid: true }], ['t,roll_deg,pitch_deg,yaw_deg,rx,ry,rz\n1,0,0,0,0,0,0\n2,0,0,0,0,0,0\n', 'input_orientation', { input_orientation: 'rotvec' }],
    [`# orispline: method\n${row}0,1,0,0,0\n1,1,0,0,0\n`, 'ignore_recipe', { ignore_recipe: true }],
  ];
  for (const [text, wanted, options] of cures) {
    const { message, remedy } = saidOf(text);
    assert.equal(remedy, wanted, message);
    assert.doesNotMatch(message, /`|--|orispline studio/, message);
    assert.ok(ask.open({ bytes: bytesOf(text), name: 'keys.csv', reading: { options, comma: false } }).document.keys.length > 0, wanted);
  }
  const large = saidOf(`${row}1700000000000,1,0,0,0\n1700000001000,1,0,0,0\n`);
  assert.deepEqual([large.message, large.remedy], ['the times are taken as milliseconds, for the first one is 1700000000000', 'time_scale']);
  const commas = 't;qw;qx;qy;qz\n0;1;0;0;0\n1;0,8;0,6;0;0\n';
  assert.match(saidOf(commas).message, /0,8/);
  assert.deepEqual(ask.open({ bytes: bytesOf(commas), name: 'keys.csv', reading: { options: {}, comma: true } }).document.keys[1].q, [0.8, 0.6, 0, 0]);
  for (const [text, name] of [['HIERARCHY\nROOT hips\n', 'walk.bvh'], ['HIERARCHY\nROOT hips\n', 'keys.csv'], ['glTF\x02', 'walk.glb'], ['{"asset":{}}', 'walk.gltf'], ['{"asset":{}}', 'keys.json'], ['hello', 'keys.csv'], ['', 'keys.csv']])
    assert.doesNotMatch(saidOf(text, name).message, /`|--|input_format/, name);
});
