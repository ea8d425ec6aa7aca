// SPDX-License-Identifier: Apache-2.0
// Every function of the package with what no argument should be: it answers, or says in one sentence of its own what is wrong.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { entry, three as keys, thrown } from './flight.mjs';

const THREE = await import(join(process.env.ORISPLINE_NPM_TOOLS, 'three/build/three.module.js'));
const [full, lite, three, { player }] = [await entry('full'), await entry('lite'), await entry('three'), await entry('player')];
const ori = await full.load(), small = await lite.load();
const csv = 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0,0,0.6\n2,0.6,0,0,0.8\n';
const positioned = { ...keys, positions: [0, 0, 0, 1, 2, 3, 4, 5, 6] };
const [curve, track] = [ori.curve('auto', positioned), ori.read(csv, 'a.csv')], smallCurve = small.curve('auto', positioned);
const turns = () => new THREE.QuaternionKeyframeTrack('.quaternion', keys.times, keys.orientations);

const gyro = { times: Array.from({ length: 200 }, (_, k) => 0.01 * k), rates: Array.from({ length: 600 }, (_, k) => Math.sin(0.05 * k)), epoch: '0' };
const walk = {
  bytes: 'HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n End Site\n {\n  OFFSET 0 1 0\n }\n}\nMOTION\nFrames: 4\nFrame Time: 0.5\n0 0 0\n0 10 0\n0 90 0\n5 90 0\n',
  name: 'a.bvh', clips: [], dropDuplicates: false,
};
const [skeleton] = ori.run('smooth', { recording: walk }, { noise: '1deg' }).skeletons;

const bare = Object.create(null), frozen = Object.freeze([0, 0, 0, 1]);
const odd = [undefined, null, 0, -1, NaN, 1e300, '', 'abc', true, 1n, Symbol('x'), [], {}, [null], [Symbol('x')], [1n], bare, frozen, () => 1, new Date(0), new Map(), new BigInt64Array(4), { length: 2 ** 40 }, { length: -1 }, { byteLength: -1 }];

/** Each of these lists of arguments has one argument, or one member of an argument, that is odd; or too few of them. */
const changed = function* (sound, members = odd) {
  for (let count = 0; count < sound.length; ++count) yield sound.slice(0, count);
  for (const [k, argument] of sound.entries()) {
    for (const other of odd) yield sound.with(k, other);
    if (argument?.constructor !== Object) continue;
    for (const name of Object.keys(argument)) for (const other of members) yield sound.with(k, { ...argument, [name]: other });
  }
};

const ofCurves = (one) => ({
  at: [[1, [0, 0, 0, 1]], (...given) => one.at(...given)],
  positionAt: [[1, [0, 0, 0]], (...given) => one.positionAt(...given)],
  motion: [[1, 'left'], (...given) => one.motion(...given)],
  'even samples': [[{ start: 0, step: 1, count: 2, rates: 1 }], (...given) => one.sample(...given)],
  'samples at times': [[{ times: [0, 1], rates: 1 }], (...given) => one.sample(...given)],
});
const ofLibraries = (library) => ({
  curve: [['timed-c2', { ...positioned, angularVelocities: undefined, signs: 'shortest' }, { tension: 0.5, ends: 'rest', closed: false }], (...given) => library.curve(...given).dispose()],
  methods: [[1], (...given) => library.methods(...given)],
});
const functions = {
  lite: { ...ofLibraries(small), ...ofCurves(smallCurve) },
  full: {
    ...ofLibraries(ori), ...ofCurves(curve),
    continuity: [[1], (...given) => curve.continuity(...given)],
    peaks: [[{ inertia: [1, 0, 0, 0, 1, 0, 0, 0, 1] }], (...given) => curve.peaks(...given)],
    bake: [[{ tolerance: 1e-3 }], (...given) => curve.bake(...given)],
    read: [[csv, 'a.csv', { sort: true, signs: 'shortest' }], (...given) => ori.read(...given).dispose()],
    write: [[keys, 'a.csv', { outputOrientation: 'euler' }], (...given) => ori.write(...given)],
    run: [['reduce', { recording: keys }, { tolerance: '1deg', methods: 'auto' }, { progress: () => false }], (...given) => ori.run(...given)],
    'run on values': [['smooth', { recording: walk, gyro: undefined }, { noise: '1deg' }], (name, ...given) => ori.run(name, ...given)],
    'a gyro': [[gyro], (one) => ori.run('align', { moved: one, fixed: gyro })],
    'a skeleton': [[walk], (one) => ori.run('inspect', { keys: one })],
    'write a skeleton': [['a.bvh', { outputEuler: 'ZYX' }], (...given) => skeleton.write(...given)],
    column: [['times', 'xyzw'], (...given) => track.column(...given)],
    data: [['xyzw'], (...given) => track.data(...given)],
  },
  three: {
    animate: [[small, turns(), 'timed-c2', { tension: 0.5 }], (one, given, ...rest) => three.animate(one, given instanceof THREE.KeyframeTrack ? turns() : given, ...rest)],
    bake: [[smallCurve, { tolerance: 1e-2 }], (...given) => three.bake(...given)],
  },
};

const isTold = (error) => error instanceof lite.OrisplineError && !/\n/.test(error.message) && error.message.length < 1000 && error.code !== 'fault';

for (const [name, list] of Object.entries(functions))
  for (const [called, [sound, call]] of Object.entries(list))
    test(`${name}: ${called}`, () => {
      call(...sound);
      for (const given of changed(sound)) {
        try {
          call(...given);
        } catch (error) {
          assert.ok(isTold(error), `${error.stack}`);
        }
      }
      call(...sound);
    });

test('load', async () => {
  for (const library of [lite, full])
    for (const given of changed([{ wasm: undefined, wasmUrl: undefined }])) await library.load(...given).catch((error) => assert.ok(isTold(error), `${error.stack}`));
});

test('player', () => {
  const file = curve.bake({ tolerance: 1e-3 });
  const ofJson = [undefined, null, 0, -1, 1e300, '', 'abc', true, [], {}, [null], [[]], [{}]];
  for (const given of [...changed([file], ofJson), [{ ...file, pieces: [...file.pieces.slice(1), null] }]]) {
    try {
      player(...given);
    } catch (error) {
      assert.match(error.message, /^orispline\/player: found [^\n]{1,80}, wanted version 1 or 2 of what 'orispline bake' writes$/, `${error.stack}`);
    }
  }
});

test('what is left out is named', () => {
  const step = 'step: found undefined, wanted times, or a step of more than 0 s';
  for (const [call, message] of [
    [() => curve.sample(), step], [() => smallCurve.sample(), step], [() => smallCurve.sample(null), step], [() => curve.sample(5), 'options: found 5, wanted an object'],
    [() => curve.peaks('abc'), 'options: found "abc", wanted an object'], [() => curve.bake(), 'tolerance: found undefined, wanted an angle [rad]'],
    [() => curve.at('1'), 'found "1", wanted a number'], [() => curve.at(), 'found undefined, wanted a number'], [() => curve.at(null), 'found null, wanted a number'],
    [() => smallCurve.at(1, null), 'target: found null, wanted an array that can be written'], [() => curve.positionAt(1, frozen), 'target: found [0,0,0,1], wanted an array that can be written'],
    [() => small.curve('auto', keys, 5), 'settings: found 5, wanted an object'], [() => ori.read(csv), 'name: found undefined, wanted a text'],
    [() => ori.write(keys), 'name: found undefined, wanted a text'], [() => ori.run(), 'task: found undefined, wanted a text'], [() => ori.run('reduce', 5), 'inputs: found 5, wanted an object'],
    [() => ori.run('reduce', { recording: keys }, 5), 'options: found 5, wanted an object'], [() => ori.run('reduce', { recording: keys }, {}, 5), 'running: found 5, wanted an object'],
    [() => track.column(), 'name: found undefined, wanted a text'], [() => three.animate(null, turns()), 'ori: found null, wanted what load() gives'],
    [() => three.animate(small), 'track: found undefined, wanted a track of three.js'], [() => three.bake(), 'curve: found undefined, wanted a curve or a player'],
    [() => three.bake(smallCurve), 'tolerance: found undefined rad, wanted 0.000001 rad or more, which is what a track holds'],
  ]) {
    const error = thrown(call);
    assert.deepEqual([error.message, error.code], [message, 'bad_argument']);
  }
});
