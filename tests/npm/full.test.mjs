// SPDX-License-Identifier: Apache-2.0
// orispline/full: files in memory and tasks beside the command.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { command, entry, flight, keysFile, opened, sampled, thrown } from './flight.mjs';
import { cases, differencesFrom } from './cases.mjs';

const full = await entry('full'), ori = await full.load();
const folder = mkdtempSync(join(tmpdir(), 'orispline-full-'));
after(() => rmSync(folder, { recursive: true }));
const text = readFileSync(keysFile, 'utf8'), truth = readFileSync(join(keysFile, '../flight_truth.csv'));

/** A glTF file with its data: nine keys of an even turn about z. */
const turn = () => {
  const times = Float32Array.from({ length: 9 }, (_, k) => k), turns = Float32Array.from({ length: 36 }, (_, k) => [0, 0, Math.sin(0.1 * (k >> 2)), Math.cos(0.1 * (k >> 2))][k % 4]);
  const data = Buffer.concat([Buffer.from(times.buffer), Buffer.from(turns.buffer)]), floats = { componentType: 5126, count: 9 };
  return JSON.stringify({
    asset: { version: '2.0' }, extras: { made: 'by a test' }, nodes: [{ name: 'arm' }],
    animations: [{ name: 'walk', samplers: [{ input: 0, output: 1 }], channels: [{ sampler: 0, target: { node: 0, path: 'rotation' } }] }],
    accessors: [{ bufferView: 0, type: 'SCALAR', min: [0], max: [8], ...floats }, { bufferView: 1, type: 'VEC4', ...floats }],
    bufferViews: [{ buffer: 0, byteLength: 36 }, { buffer: 0, byteOffset: 36, byteLength: 144 }],
    buffers: [{ byteLength: 180, uri: `data:application/octet-stream;base64,${data.toString('base64')}` }],
  });
};

test('it gives what the cases of the C interface say, bit for bit', () => assert.deepEqual(differencesFrom(cases, ori, true), []));

test('a file that is read has the keys of the file and what it says of them', () => {
  const keys = ori.read(text, 'flight_keys.csv'), { times, orientations, positions } = keys.data('wxyz');
  assert.deepEqual([keys.info.count, keys.info.method, keys.info.name], [38, null, 'flight_keys.csv']);
  assert.deepEqual([...times], flight.times);
  assert.deepEqual([...positions], flight.positions);
  assert.ok(orientations.every((x, k) => Math.abs(x - flight.orientations[k]) < 1e-9));
  const curve = ori.curve('auto', keys.data('wxyz')), rows = sampled('--method', 'auto', '--rate', '5');
  assert.deepEqual([...curve.sample({ times: rows.map(([t]) => t) }).orientations], rows.flatMap((row) => row.slice(1, 5)));
  assert.deepEqual(keys.column('orientations', 'xyzw').slice(0, 4), Float64Array.of(...[1, 2, 3, 0].map((k) => orientations[k])));
});

test('keys are written in every format that their name says', () => {
  const tum = new TextDecoder().decode(ori.write({ ...flight, positions: undefined }, 'keys.tum', {}).bytes);
  assert.deepEqual(ori.write(flight, 'keys.csv').warnings, []);
  assert.equal(tum.split('\n').filter((row) => /^\d/.test(row)).length, 38);
  const again = ori.read(ori.write(flight, 'again.csv').bytes, 'again.csv').data('wxyz');
  assert.deepEqual([...again.positions], flight.positions);
});

test('a task finds what the command finds', () => {
  const recording = ori.read(truth, 'flight_truth.csv');
  const found = ori.run('reduce', { recording }, { tolerance: '0.5deg', methods: 'auto' });
  const output = join(folder, 'keys.csv');
  const wanted = JSON.parse(command('reduce', join(keysFile, '../flight_truth.csv'), '--tolerance', '0.5deg', '--method', 'auto', '--json', '-o', output));
  for (const name of ['samples', 'method', 'keys', 'error_max_deg']) assert.deepEqual(found.document[name], wanted[name], name);
  assert.deepEqual([found.tracks.length, found.tracks[0].info.count], [1, wanted.keys]);
  assert.match(found.summary, /largest error/);
  const curve = ori.curve('auto', found.tracks[0].data('xyzw'));
  assert.equal(curve.start, 0);
});

/** A body that turns about z, and what a gyro on it says: noisy orientations at 50 Hz, rates at 200 Hz on a clock that began 100 s earlier. */
const turning = () => {
  const at = (count, step) => Array.from({ length: count }, (_, k) => step * k), angle = (t) => 0.8 * Math.sin(2 * t), noise = (k) => 0.004 * Math.sin(12.9898 * (k + 1) ** 1.5);
  const times = at(150, 0.02), own = at(600, 0.005);
  const orientations = times.flatMap((t, k) => [0, 0, Math.sin((angle(t) + noise(k)) / 2), Math.cos((angle(t) + noise(k)) / 2)]);
  const rates = own.flatMap((t, k) => [noise(3 * k), noise(3 * k + 1), 1.6 * Math.cos(2 * t) + noise(3 * k + 2)]);
  return { recording: { times, orientations, order: 'xyzw' }, gyro: { times: own.map((t) => t + 100), rates, epoch: '-100' } };
};

test('a recording is smoothed with a gyro that has a clock of its own', () => {
  const { recording, gyro } = turning(), { document, tracks, line } = ori.run('smooth', { recording, gyro });
  assert.equal(document.gyro_used, true);
  assert.ok(line.length > 20 && !line.includes('\n'), line);
  const [z] = ori.curve('auto', tracks[0].data('xyzw')).motion(1).angularVelocity.slice(2);
  assert.ok(Math.abs(z - 1.6 * Math.cos(2)) < 0.02, `${z}`);
  assert.equal(ori.run('smooth', { recording, gyro: undefined }).document.gyro_used, null);
});

test('a gyro is aligned, and what comes of it is taken again', () => {
  const { recording, gyro } = turning(), late = { ...gyro, times: gyro.times.map((t) => t + 0.03) };
  const { document, rates, tracks } = ori.run('align', { moved: late, fixed: gyro }, { offset: '0.03s' });
  assert.deepEqual([document.compared > 0, rates.length, tracks.length], [true, 1, 0]);
  assert.deepEqual([rates[0].times.length, rates[0].rates.length, typeof rates[0].epoch], [600, 1800, 'string']);
  assert.equal(ori.run('smooth', { recording, gyro: rates[0] }).tracks.length, 1);
});

test('a glTF file is reduced, written with what else it held, and compared with what it was', () => {
  const bytes = Buffer.from(turn()), walk = { bytes, name: 'turn.gltf' };
  const { skeletons: [small], tracks } = ori.run('reduce', { recording: walk }, { tolerance: '0.1deg' });
  assert.deepEqual([small.info.format, small.info.joints, small.info.clips, tracks], ['gltf', ['arm'], ['walk'], []]);
  const file = JSON.parse(new TextDecoder().decode(small.write('small.gltf').bytes));
  assert.equal(file.extras.made, 'by a test');
  assert.ok(file.accessors.some(({ count, type }) => type === 'SCALAR' && count === 2));
  const apart = ori.run('difference', { first: walk, second: small }, { rate: 24 });
  assert.ok(apart.summary.length > 20);
  assert.deepEqual(ori.run('inspect', { keys: small }).document.joints, ori.run('inspect', { keys: walk }).document.joints);
  small.dispose();
  assert.equal(thrown(() => small.info).code, 'disposed');
});

test('two recordings are compared', () => {
  const reference = ori.read(truth, 'flight_truth.csv'), { document } = ori.run('compare', { keys: flight, reference }, { methods: 'slerp,auto' });
  assert.deepEqual(document.map(({ method }) => method).sort(), ['auto', 'slerp']);
});

test('every task is listed, and its options are those of the command', () => {
  assert.deepEqual(ori.tasks(), JSON.parse(command('tasks', '--json')));
  const { tracks } = ori.run('retime', { keys: flight }, { maxRate: '20deg/s' });
  assert.ok(ori.curve('auto', tracks[0].data('wxyz')).peaks().angularVelocity.value <= (Math.PI / 180) * 20);
});

for (const [call, about] of [
  [() => ori.read('t,qw,qx,qy,qz\n0,1,0,0,0\n1,x,0,0,0\n', 'a.csv'), { code: 'bad_data', line: 3 }],
  [() => ori.read(text, 'a.csv', { angleunit: 'deg' }), { code: 'bad_argument', message: "unknown option 'angleunit'; did you mean 'angle_unit'?" }],
  [() => ori.read(text, 'a.csv', { sort: [1] }), { code: 'bad_argument', option: 'sort', message: 'sort: found [1], wanted a text, a number or a flag' }],
  [() => ori.write(flight, 'a.xyz'), { code: 'bad_argument' }],
  [() => ori.run('redce', { recording: flight }), { code: 'bad_argument', message: "unknown task 'redce'; did you mean 'reduce'?" }],
  [() => ori.run('reduce', { keys: flight }, { tolerance: '1deg' }), { code: 'bad_argument', option: 'keys' }],
  [() => ori.run('reduce', { recording: flight }), { code: 'bad_argument', option: 'tolerance' }],
  [() => ori.run('reduce', { recording: flight }, { tolerance: '1' }), { code: 'bad_argument', option: 'tolerance' }],
  [() => ori.run('smooth', { recording: flight, gyro: flight }), { code: 'bad_argument', message: 'gyro: found orientations at times, wanted the rates of a gyro' }],
  [() => ori.run('smooth', { recording: flight, gyro: { times: [0, 1], rates: [1, 2] } }), { code: 'bad_argument', message: 'rates: found 2 numbers, wanted 6, 3 for each of 2 times' }],
  [() => ori.run('smooth', { recording: { bytes: 'HIERARCHY', name: 'walk.bvh' } }), { code: 'bad_data' }],
  [() => ori.run('smooth', { recording: { bytes: turn(), name: 'turn.gltf', clips: ['run'] } }), { code: 'bad_data', message: "found no clip 'run', wanted one of 'walk'" }],
  [() => ori.run('difference', { first: { bytes: turn(), name: 'turn.gltf' } }), { code: 'bad_argument', option: 'second' }],
  [() => ori.run('reduce', { recording: { ...flight, order: 'xwyz' } }, { tolerance: '1deg' }), { code: 'bad_argument', option: 'order' }],
])
  test(`it refuses: ${JSON.stringify(about)}`, () => {
    const error = thrown(call);
    for (const [name, value] of Object.entries(about)) assert.equal(error[name], value, error.message);
    assert.equal(error.message.includes('\n'), false);
  });

test('a task tells its progress, is stopped by it, and the library goes on', () => {
  const recording = ori.read(truth, 'flight_truth.csv'), options = { noise: '0.1deg' }, shares = [];
  const smooth = (progress) => ori.run('smooth', { recording }, options, { progress });
  const found = smooth((share) => void shares.push(share));
  assert.ok(shares.length > 2 && shares.every((share, k) => k === 0 || share >= shares[k - 1]), `${shares}`);
  assert.equal(shares.at(-1), 1);
  let calls = 0;
  const stopped = thrown(() => smooth((share) => (++calls, share > 0)));
  assert.deepEqual([stopped.code, calls < shares.length], ['cancelled', true]);
  assert.ok(stopped instanceof full.OrisplineError);
  const mine = new Error('mine');
  assert.equal(thrown(() => smooth(() => { throw mine; })), mine);
  assert.equal(thrown(() => smooth((share) => { if (share === 1) throw mine; })), mine);
  // Calls of the library meanwhile, and a task within a task, which tells its own progress.
  const curve = ori.curve('auto', flight), same = curve.at(3), within = [];
  const again = smooth(() => {
    assert.deepEqual(curve.at(3), same);
    if (within.length === 0) ori.run('retime', { keys: flight }, { duration: '60s' }, { progress: (share) => void within.push(share) });
    thrown(() => ori.curve('sqad', flight));
  });
  assert.deepEqual(again.document, found.document);
  assert.equal(within.at(-1), 1);
  assert.deepEqual(smooth(undefined).document, found.document);
  for (const progress of [5, 'abc', {}]) assert.equal(thrown(() => smooth(progress)).option, 'progress');
});

test('a file may be any bytes, and its options and names are whole', () => {
  const bytes = new TextEncoder().encode(text), shared = new Uint8Array(new SharedArrayBuffer(bytes.length));
  shared.set(bytes);
  for (const content of [text, bytes, bytes.buffer, new DataView(bytes.buffer), shared]) assert.equal(ori.read(content, 'a.csv').info.count, 38);
  for (const content of [undefined, null, 5]) assert.equal(thrown(() => ori.read(content, 'a.csv')).option, 'bytes');
  for (const call of [() => ori.read(text, 'a.csv\0.bvh'), () => ori.read(text, 'a.csv', { 'sort\0': true }), () => ori.run('reduce', { recording: flight }, { tolerance: '1deg\0x' })])
    assert.match(thrown(call).message, /wanted a text without a zero in it$/);
});

test('keys of another load() are refused, for their memory is another', async () => {
  const others = (await full.load()).read(text, 'a.csv');
  for (const call of [() => ori.write(others, 'a.csv'), () => ori.run('retime', { keys: others }, { duration: '60s' })])
    assert.equal(thrown(call).message, 'keys: found some that another load() made, wanted those of this one');
  assert.equal(ori.read(text, 'a.csv').info.count, 38);
});

test('keys that were disposed of say so, and leave no memory behind', async () => {
  const keys = ori.read(text, 'flight_keys.csv');
  keys.dispose();
  keys.dispose();
  assert.equal(thrown(() => keys.info).message, 'found keys that were disposed of, wanted some that were not');
  const { library, exports } = await opened(full.load);
  const work = (count) => {
    for (let k = 0; k < count; ++k) {
      const read = library.read(text, 'flight_keys.csv');
      for (const track of library.run('retime', { keys: read }, { duration: '60s' }).tracks) track.dispose();
      read.dispose();
      thrown(() => library.read('t,qw\n', 'a.csv'));
    }
    return exports.memory.buffer.byteLength;
  };
  assert.equal(work(20), work(100));
});
