// SPDX-License-Identifier: Apache-2.0
// orispline, all methods: the bits of the command, what curves are worth, and baking.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { apart, command, entry, flight, keysFile, opened, sampled, three, thrown } from './flight.mjs';
import { cases, differencesFrom } from './cases.mjs';

const whole = await entry('index'), ori = await whole.load();
const { player } = await entry('player');
const registry = JSON.parse(command('methods', '--json'));

/** Those that the keys of the flight are enough for: `bezier` wants 37 or 40, those of Hermite want rates. */
const methods = registry.map(({ name }) => name).filter((name) => name !== 'bezier' && !name.startsWith('hermite-c'));

test('it gives what the cases of the C interface say, bit for bit', () => assert.deepEqual(differencesFrom(cases, ori, true), []));

test('methods() says what the registry says', () => assert.deepEqual(ori.methods(), registry));

for (const method of methods)
  test(`samples by ${method} have the bits of the command`, () => {
    const rows = sampled('--method', method, '--rate', '20'), curve = ori.curve(method, flight);
    const found = curve.sample({ times: rows.map(([t]) => t), rates: 2 });
    for (const [numbers, from, width] of [[found.orientations, 1, 4], [found.positions, 5, 3], [found.angularVelocities, 8, 3], [found.angularAccelerations, 11, 3]])
      assert.deepEqual([...numbers], rows.flatMap((row) => row.slice(from, from + width)));
  });

test('even samples are those at their times', () => {
  const curve = ori.curve('auto', flight), even = curve.sample({ start: 1, step: 0.125, count: 300, rates: 3 });
  assert.deepEqual(curve.sample({ times: even.times, rates: 3 }), even);
  assert.ok(apart(even.orientations.subarray(40, 44), curve.at(even.times[10])) < 1e-14);
  assert.equal(curve.sample({ times: [] }).orientations.length, 0);
  assert.equal(even.angularJerks.length, 900);
});

test('what a curve is worth: continuity, peaks, its method', () => {
  const found = ori.curve('auto', flight).continuity(), slerp = ori.curve('slerp', flight).continuity();
  assert.equal(found.order, 2);
  assert.equal(slerp.order, 0);
  assert.deepEqual(ori.curve('auto', flight).orders(), Int8Array.from(flight.times, (_, k) => (k % 37 ? 2 : 3)));
  assert.equal(Math.min(...ori.curve('slerp', flight).orders()), 0);
  assert.ok(slerp.angularVelocity.largest > 0.5 && Number.isInteger(slerp.angularVelocity.key));
  const steady = ori.curve('slerp', three).peaks();
  assert.ok(Math.abs(steady.angularVelocity.value - 2 * Math.asin(0.6)) < 1e-12);
  assert.equal(steady.torque, undefined);
  const { torque, angularAcceleration } = ori.curve('auto', flight).peaks({ inertia: [1, 0, 0, 0, 1, 0, 0, 0, 1] });
  assert.ok(Math.abs(torque.value / angularAcceleration.value - 1) < 1e-9);
  assert.ok(torque.bound >= torque.value && torque.bound <= 1.001 * torque.value);
  assert.equal('bound' in ori.curve('squad', flight).peaks().angularVelocity, false);
  assert.equal(thrown(() => ori.curve('auto', three).peaks({ inertia: [1, 2, 3] })).option, 'inertia');
  assert.equal(ori.curve('timed-c2', three, { tension: 0.25 }).method, 'timed-c2:tension=0.25');
});

test('what it bakes is what the command bakes, and is played', () => {
  const tolerance = (Math.PI / 180) * 1e-4, file = ori.curve('auto', flight).bake({ tolerance });
  const wanted = JSON.parse(command('bake', keysFile, '--tolerance', '1e-4deg', '--quiet'));
  assert.deepEqual(file, wanted);
  const motion = player(file), curve = ori.curve('auto', flight), [w, x, y, z] = curve.at(17.3);
  assert.ok(apart(motion.at(17.3), [x, y, z, w]) < tolerance);
  assert.ok(apart(motion.positionAt(17.3), curve.positionAt(17.3)) < 1e-3);
  assert.equal(player(ori.curve('auto', { ...flight, positions: undefined }).bake({ tolerance })).hasPositions, false);
  assert.equal(thrown(() => curve.bake({ tolerance, positionTolerance: '1mm' })).option, 'positionTolerance');
  const one = ori.curve('auto', { times: [2], orientations: [0, 0, 1, 0], order: 'xyzw' }).bake({ tolerance: 1e-3 });
  assert.deepEqual(player(one).at(5), [0, 0, 1, 0]);
  const error = thrown(() => ori.curve('auto', flight).bake({ tolerance: 0 }));
  assert.deepEqual([error.code, error.message], ['bad_argument', 'tolerance: the tolerance is 0 rad, wanted a number from 1e-06 on']);
});

test('a tolerance that is missed names one that is kept', () => {
  const near = { times: [0, 1, 1.0000001, 2, 3], orientations: [1, 0, 0, 0, 0.6, 0.8, 0, 0, 0.6, 0, 0.8, 0, 0, 0, 0, 1, 1, 0, 0, 0], order: 'wxyz' };
  const curve = ori.curve('rational', near), error = thrown(() => curve.bake({ tolerance: 1e-6 }));
  const offered = Number(/^key 0: tolerance: at \S+ s even the shortest piece reaches \S+ rad, wanted 1e-06: ask for (\S+) rad or more, which all of the curve keeps to$/.exec(error.message)?.[1]);
  assert.ok(2 * curve.bake({ tolerance: offered }).largest_difference <= offered, error.message);
});

test('its errors are those of the small package, word for word', async () => {
  const lite = await (await entry('lite')).load();
  for (const [method, keys, settings] of [
    ['timed-c2', three, { tension: 1e9 }], ['timed-c2', three, { tension: -123.456789 }], ['timed-c2', three, { tension: [1, 2] }], ['timed-c2', three, { ends: 'natral' }],
    ['timed-c2', three, { tension: 1e-5, ends: 'x,y' }], ['auto', three, { hold: 2 }], ['auto', { ...three, times: [0, 1, 1] }, {}], ['auto', { ...three, times: [0, 1e300, 1e17] }, {}],
    ['auto', { ...three, times: [0, 1e-200, 1] }, {}], ['slerp', { ...three, times: [0, NaN, 1] }, {}], ['slerp', { ...three, orientations: three.orientations.map((x) => x * 1.01234567) }, {}],
    ['timed-c2', three, { closed: true, period: 1 }], ['timed-c2', three, { startRate: [1, 2] }], ['timed-c2', three, { period: -0.1 }],
    ['auto', { ...three, positions: [0, 0, 0, 1, 1, Infinity, 2, 2, 2] }, {}], ['timed-c2', { ...three, angularVelocities: [1, 2, 3, NaN, 0, 0, 0, 0, 0] }, {}],
  ]) {
    const [one, other] = [ori, lite].map((library) => {
      try {
        library.curve(method, keys, settings).dispose();
        return null;
      } catch (error) {
        return { message: error.message, code: error.code, key: error.key, option: error.option, remedy: error.remedy };
      }
    });
    assert.deepEqual(other, one);
  }
});

test('curves, samples and baked curves leave no memory behind', async () => {
  const { library, exports } = await opened(whole.load);
  const work = (count) => {
    for (let k = 0; k < count; ++k) {
      const curve = library.curve('quintic', three, { tension: 0.4 });
      curve.sample({ step: 0.1, count: 20, rates: 3 });
      curve.continuity();
      curve.orders();
      curve.bake({ tolerance: 1e-3 });
      curve.dispose();
      thrown(() => library.curve('quintic', three, { tension: [1, 2] }));
    }
    return exports.memory.buffer.byteLength;
  };
  Error.stackTraceLimit = 0;
  assert.equal(work(100), work(5000));
  Error.stackTraceLimit = 10;
});

test('counts that memory cannot hold are refused, also those that 32 bits would cut', () => {
  const curve = ori.curve('auto', three);
  for (const count of [2 ** 27, 2 ** 27 + 1, 2 ** 32, 2 ** 32 + 1, 2 ** 53 - 1]) assert.equal(thrown(() => curve.sample({ step: 1e-9, count })).code, 'no_memory');
  assert.equal(thrown(() => curve.sample({ step: 1e-9, count: 2 ** 26, rates: 3 })).code, 'no_memory');
  assert.equal(thrown(() => curve.bake({ tolerance: 1n })).code, 'bad_argument');
  assert.equal(curve.sample({ step: 0.1, count: 0 }).times.length, 0);
});

test('where there is no memory for another library, it says so', async () => {
  const { Instance } = WebAssembly;
  WebAssembly.Instance = function () {
    throw new RangeError('could not allocate memory');
  };
  try {
    await assert.rejects(whole.load(), { code: 'no_memory' });
  } finally {
    WebAssembly.Instance = Instance;
  }
});

test('a module of another entry is refused', async () => {
  const { readFileSync } = await import('node:fs');
  const small = readFileSync(join(process.env.ORISPLINE_NPM, 'lite.wasm'));
  await assert.rejects(whole.load({ wasm: small }), { code: 'bad_data', message: /^found WebAssembly of something else/ });
});
