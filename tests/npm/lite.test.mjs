// SPDX-License-Identifier: Apache-2.0
// orispline/lite beside the command, and what it refuses.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { apart, command, entry, flight, keysFile, opened, sampled, three, thrown } from './flight.mjs';
import { cases, differencesFrom } from './cases.mjs';

const lite = await entry('lite'), ori = await lite.load();
const wasm = join(process.env.ORISPLINE_NPM, 'lite.wasm');
const wanted = ['auto', 'slerp', 'squad', 'timed-c2'];

test('it gives what the cases of the C interface say, bit for bit', () => assert.deepEqual(differencesFrom(cases, ori, false), []));

test('every method moves the flight as the command does, with rates and positions', () => {
  for (const method of ['auto', 'slerp', 'squad', 'timed-c2', 'timed-c2:tension=0.3:ends=natural']) {
    const rows = sampled('--method', method, '--rate', '50'), curve = ori.curve(method, flight);
    const found = curve.sample({ step: 0.02, count: rows.length, rates: 2 });
    assert.deepEqual([curve.start, curve.end], [0, 48]);
    assert.ok(apart(found.times, rows.map(([t]) => t)) < 1e-12, method);
    const parts = [[found.orientations, 1, 4, 1e-13], [found.positions, 5, 3, 1e-9], [found.angularVelocities, 8, 3, 1e-11], [found.angularAccelerations, 11, 3, 1e-9]];
    for (const [numbers, from, width, least] of parts) {
      const told = rows.flatMap((row) => row.slice(from, from + width)), largest = told.reduce((most, x) => Math.max(most, Math.abs(x)), 1);
      assert.equal(numbers.length, told.length);
      assert.ok(apart(numbers, told) < least * largest, `${method}: ${apart(numbers, told)}`);
    }
  }
});

test('settings are numbers, lists, words and flags', () => {
  const same = (settings, text) =>
    assert.deepEqual(ori.curve('timed-c2', three, settings).at(1.3), ori.curve(text, three).at(1.3));
  same({ tension: 0.7 }, 'timed-c2:tension=0.7');
  same({ tension: [0.5, 1, 0.25] }, 'timed-c2:tension=0.5,1,0.25');
  same({ tension: Float64Array.of(0.5, 1, 0.1 + 0.2), tension2: undefined, closed: false }, 'timed-c2:tension=0.5,1,0.30000000000000004');
  same({ ends: 'natural' }, 'timed-c2:ends=natural');
  same({ ends: 'clamped', startRate: [0, 0, 1], end_rate: [0, 1, 0] }, 'timed-c2:ends=clamped:start_rate=0,0,1:end_rate=0,1,0');
  same({ period: 4 }, 'timed-c2:period=4');
});

test('both orders are the same motion', () => {
  const turned = { ...three, order: 'wxyz', orientations: [1, 0, 0, 0, 0.8, 0, 0, 0.6, 0.8, 0.6, 0, 0] };
  const [x, y, z, w] = ori.curve('auto', three).at(0.7);
  assert.deepEqual(ori.curve('auto', turned).at(0.7), [w, x, y, z]);
  assert.deepEqual(ori.curve('auto', turned).motion(0.7).orientation, [w, x, y, z]);
});

test('a motion has rates, on either side of a key, and a position where the keys have one', () => {
  const slerp = ori.curve('slerp', three), [before, after] = [slerp.motion(1, 'left'), slerp.motion(1)];
  assert.ok(apart(before.angularVelocity, [0, 0, 2 * Math.asin(0.6)]) < 1e-15);
  assert.ok(apart(before.angularVelocity, after.angularVelocity) > 0.1);
  assert.deepEqual(Object.keys(after), ['orientation', 'angularVelocity', 'angularAcceleration', 'angularJerk']);
  assert.deepEqual(ori.curve('auto', { ...three, positions: [0, 0, 0, 1, 2, 3, 4, 5, 6] }).motion(1).position, [1, 2, 3]);
});

test('outside the ends are held, and NaN gives NaN', () => {
  const curve = ori.curve('auto', three);
  assert.deepEqual(curve.at(-7), curve.at(0));
  assert.ok(apart(curve.at(-7), three.orientations.slice(0, 4)) < 1e-15);
  assert.deepEqual(curve.motion(9).angularVelocity, [0, 0, 0]);
  assert.ok(curve.at(NaN).every(Number.isNaN));
});

test('samples are those of given times, or of even ones up to the end', () => {
  const curve = ori.curve('auto', three), { times, orientations, angularVelocities } = curve.sample({ step: 0.5 });
  assert.deepEqual([...times], [0, 0.5, 1, 1.5, 2, 2.5]);
  assert.deepEqual([...orientations.subarray(8, 12)], curve.at(1));
  assert.equal(angularVelocities, undefined);
  assert.deepEqual([...curve.sample({ start: 1, step: 0.1, count: 3 }).times], [1, 1.1, 1.2]);
  const given = curve.sample({ times: [2, 1], rates: 3 });
  assert.deepEqual([...given.orientations], [...curve.at(2), ...curve.at(1)]);
  assert.deepEqual([...given.angularJerks.subarray(3)], curve.motion(1).angularJerk);
  assert.equal(curve.sample({ times: [] }).orientations.length, 0);
});

test('methods() says what the registry says', () => {
  const all = JSON.parse(command('methods', '--json'));
  assert.deepEqual(ori.methods(), all.filter(({ name }) => wanted.includes(name)));
  for (const { name } of ori.methods()) ori.curve(name, three).dispose();
  assert.equal(thrown(() => ori.curve('quintic', three)).code, 'bad_argument');
});

const broken = (keys) => () => ori.curve('auto', { ...three, ...keys });
for (const [call, about] of [
  [broken({ times: [0, 1, 1] }), { code: 'bad_data', key: 2, message: 'key 2: duplicate time 1, wanted strictly increasing times' }],
  [broken({ times: [0, 2, 1.5] }), { code: 'bad_data', key: 2, message: 'key 2: time 1.5 comes after 2, wanted strictly increasing times' }],
  [broken({ times: [0, NaN, 2] }), { code: 'bad_data', key: 1, message: 'key 1: time is nan, wanted a finite number' }],
  [broken({ times: [] }), { code: 'bad_argument', option: 'orientations', message: 'orientations: found 12 numbers, wanted 0, 4 for each of 0 times' }],
  [broken({ times: undefined }), { code: 'bad_argument', option: 'times', message: 'times: found none, wanted an array of numbers' }],
  [broken({ orientations: new Float32Array(12) }), { code: 'bad_data', key: 0, message: 'key 0: the quaternion has norm 0, wanted 1 within 0.001' }],
  [broken({ orientations: three.orientations.with(5, NaN) }), { code: 'bad_data', key: 1, message: 'key 1: the quaternion has a component that is not finite, wanted a unit quaternion' }],
  [broken({ orientations: [1, 0, 0] }), { code: 'bad_argument', option: 'orientations', message: 'orientations: found 3 numbers, wanted 12, 4 for each of 3 times' }],
  [broken({ positions: [1] }), { code: 'bad_argument', option: 'positions', message: 'positions: found 1 numbers, wanted 9, 3 for each of 3 times' }],
  [broken({ order: undefined }), { code: 'bad_argument', option: 'order', message: "order: found undefined, wanted 'wxyz' or 'xyzw'" }],
  [broken({ signs: 'given' }), { code: 'bad_argument', option: 'signs', message: 'signs: found "given", wanted \'shortest\' or \'as-given\'' }],
  [() => ori.curve('tmed-c2', three), { code: 'bad_argument', message: "unknown method 'tmed-c2'; did you mean 'timed-c2'?" }],
  [() => ori.curve(7, three), { code: 'bad_argument', option: 'method', message: "method: found 7, wanted its name, such as 'auto'" }],
  [() => ori.curve('timed-c2', three, { tension: [1, 2] }), { code: 'bad_argument', message: 'timed-c2: found 2 values of tension, wanted 1 or one per key (3)' }],
  [() => ori.curve('timed-c2', three, { tension: 1e9 }), { code: 'bad_argument', message: 'timed-c2: tension is 1000000000, wanted -100 to 100' }],
  [() => ori.curve('timed-c2', three, { ends: 'natral' }), { code: 'bad_argument', option: 'ends', message: "ends: timed-c2: unknown end rule 'natral'; did you mean 'natural'?" }],
  [() => ori.curve('timed-c2', three, { ends: 'a:closed' }), { code: 'bad_argument', option: 'ends', message: "ends: found 'a:closed', wanted a word or numbers" }],
  [() => ori.curve('auto', three).sample({ step: 0 }), { code: 'bad_argument', option: 'step', message: 'step: found 0, wanted times, or a step of more than 0 s' }],
  [broken({ times: [0n, 1n, 2n] }), { code: 'bad_argument', option: 'times', message: 'times: found something else (Cannot convert a BigInt value to a number), wanted numbers' }],
  [broken({ times: '012' }), { code: 'bad_argument', option: 'times', message: 'times: found none, wanted an array of numbers' }],
  [broken({ times: { length: -1 }, orientations: { length: -4 } }), { code: 'bad_argument', option: 'times', message: 'times: found none, wanted an array of numbers' }],
  [broken({ times: { length: 2 ** 29 + 1 }, orientations: { length: 2 ** 31 + 4 } }), { code: 'no_memory', message: 'found no memory for 4294967304 bytes more, wanted fewer keys or samples' }],
  [broken({ order: 1n }), { code: 'bad_argument', option: 'order', message: "order: found something of the type bigint, wanted 'wxyz' or 'xyzw'" }],
  [broken({ order: [1n] }), { code: 'bad_argument', option: 'order', message: "order: found something of the type object, wanted 'wxyz' or 'xyzw'" }],
  [() => ori.curve('auto'), { code: 'bad_argument', option: 'keys', message: 'keys: found undefined, wanted { times, orientations, order }' }],
  [() => ori.curve('auto', null), { code: 'bad_argument', option: 'keys', message: 'keys: found null, wanted { times, orientations, order }' }],
  [() => ori.curve('auto\0:closed', three), { code: 'bad_argument', message: 'found "auto\\u0000:closed", wanted a text without a zero in it' }],
  [() => ori.curve('timed-c2', three, { tension: null }), { code: 'bad_argument', option: 'tension', message: "tension: found 'null', wanted a word or numbers" }],
  [() => ori.curve('timed-c2', three, { tension: ['0.5:closed'] }), { code: 'bad_argument', option: 'tension', message: "tension: found '0.5:closed', wanted a word or numbers" }],
  [() => ori.curve('timed-c2', three, { 'tension=1:closed': 1 }), { code: 'bad_argument', option: 'tension=1:closed', message: "tension=1:closed: found '1', wanted a word or numbers" }],
  [() => ori.curve('auto', three).at(1n), { code: 'bad_argument', message: 'found something of the type bigint, wanted a number' }],
  [() => ori.curve('auto', three).motion(Symbol('x')), { code: 'bad_argument', message: 'found something of the type symbol, wanted a number' }],
  [() => ori.curve('auto', three).motion(1, 'middle'), { code: 'bad_argument', option: 'side', message: 'side: found "middle", wanted \'right\' or \'left\'' }],
  [() => ori.curve('auto', three).sample({ times: 5 }), { code: 'bad_argument', option: 'times', message: 'times: found none, wanted an array of numbers' }],
  [() => ori.curve('auto', three).sample({ step: 1, count: NaN }), { code: 'bad_argument', option: 'count', message: 'count: found NaN, wanted a whole number from 0 on' }],
  [() => ori.curve('auto', three).sample({ times: [0], rates: -1 }), { code: 'bad_argument', option: 'rates', message: 'rates: found -1, wanted 0, 1, 2 or 3' }],
  [() => ori.curve('auto', three).sample({ step: Infinity }), { code: 'bad_argument', option: 'step', message: 'step: found Infinity, wanted times, or a step of more than 0 s' }],
  [() => ori.curve('auto', three).sample({ step: 1, start: NaN, count: 3 }), { code: 'bad_argument', option: 'start', message: 'start: found NaN, wanted a time [s]' }],
  [() => ori.curve('auto', three).sample({ step: 1, count: 2 ** 27 }), { code: 'no_memory', message: 'found no memory for 4294967296 bytes more, wanted fewer keys or samples' }],
  [() => ori.curve('auto', three).sample({ step: 2 ** -60 }), { code: 'no_memory', message: 'found no memory for 92233720368547760000 bytes more, wanted fewer keys or samples' }],
  [() => ori.curve('auto', three).sample({ step: 1, count: 1.5 }), { code: 'bad_argument', option: 'count', message: 'count: found 1.5, wanted a whole number from 0 on' }],
])
  test(`it refuses: ${about.message}`, () => {
    const { code, message, key, line, option } = thrown(call);
    assert.deepEqual({ code, message, key, line, option }, { key: undefined, line: undefined, option: undefined, ...about });
  });

test('its sentences are those of the command', () => {
  for (const method of ['slrp', 'timed-c2:tension=1e5', 'timed-c2:tension=-123.456789', 'timed-c2:ends=x,y', 'auto:hold=2', 'squad:closed', 'timed-c2:period=3']) {
    const said = thrown(() => command('sample', keysFile, '--method', method, '--count', '3')).stderr.trim().replace(/^orispline: (--[\w-]+: )*/, '');
    const found = thrown(() => ori.curve(method, flight));
    // The command has more methods to name, and names its options in its own way.
    const tail = (text) => text.replace(/, wanted one of .*| did you mean.*/, '').replace(/^[a-z_]+: /, '');
    assert.ok(tail(found.message).endsWith(tail(said)) || tail(said).endsWith(tail(found.message)), `${found.message} | ${said}`);
  }
});

test('a curve that was disposed of says so', () => {
  const curve = ori.curve('auto', three);
  curve.dispose();
  curve.dispose();
  for (const call of [() => curve.at(1), () => curve.motion(1), () => curve.sample({ step: 1 })]) {
    const error = thrown(call);
    assert.deepEqual([error.code, error.message], ['disposed', 'found a curve that was disposed of, wanted one that was not']);
    assert.ok(error instanceof lite.OrisplineError && error instanceof Error);
  }
  const another = ori.curve('auto', three);
  another[Symbol.dispose]();
  assert.equal(thrown(() => another.at(1)).code, 'disposed');
});

test('bytes, a module and a place are taken, and nothing else', async () => {
  const bytes = readFileSync(wasm), at = (library) => library.curve('auto', three).at(0.5);
  const same = ori.curve('auto', three).at(0.5);
  for (const options of [{ wasm: bytes }, { wasm: new Uint8Array(bytes).buffer }, { wasm: new WebAssembly.Module(bytes) }, { wasm: Promise.resolve(bytes) }, { wasm: runInNewContext('new Uint8Array(bytes).buffer', { bytes }) }, { wasm: runInNewContext('new WebAssembly.Module(new Uint8Array(bytes))', { bytes }) }, { wasmUrl: new URL(`file://${wasm}`) }])
    assert.deepEqual(at(await lite.load(options)), same);
  const other = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
  for (const [options, code, found] of [
    [{ wasm: new TextEncoder().encode('<!doctype html>') }, 'bad_data', 'found 15 bytes that are no WebAssembly'],
    [{ wasm: bytes.subarray(0, 999) }, 'bad_data', 'found WebAssembly that does not compile'],
    [{ wasm: other }, 'bad_data', 'found WebAssembly of something else'],
    [{ wasmUrl: new URL('file:///no/such.wasm') }, 'bad_access', 'file:///no/such.wasm: found no WebAssembly there'],
  ])
    await assert.rejects(lite.load(options), (error) => error.code === code && error.message.startsWith(found) && !error.message.includes('\n'));
});

test('a browser without SIMD is told so', async () => {
  const { validate } = WebAssembly;
  WebAssembly.validate = () => false;
  try {
    await assert.rejects(lite.load(), { code: 'not_supported', message: /^found no WebAssembly with SIMD here, wanted Chrome 91/ });
  } finally {
    WebAssembly.validate = validate;
  }
});

test('after a trap every call says that there was one', async () => {
  let falls = false;
  const fall = () => {
    if (falls) throw new WebAssembly.RuntimeError('unreachable');
    return 0;
  };
  const { library } = await opened(lite.load, { orispline_curve_orientation: fall });
  const [curve, other] = [library.curve('auto', three), library.curve('slerp', three)];
  falls = true;
  const fault = { code: 'fault', message: /^found a fault of orispline \(unreachable\), wanted none: please report it/ };
  assert.throws(() => curve.at(1), fault);
  for (const call of [() => curve.at(1), () => other.motion(1), () => library.curve('auto', three)]) assert.throws(call, fault);
  curve.dispose();
});

test('where memory has run out, that is said, and not that there is a fault', async () => {
  let library, exports;
  const fall = () => {
    Object.defineProperty(exports.memory, 'buffer', { value: { byteLength: 4e9 } });
    throw new WebAssembly.RuntimeError('unreachable');
  };
  ({ library, exports } = await opened(lite.load, { orispline_curve_orientation: fall }));
  const curve = library.curve('auto', three);
  for (const call of [() => curve.at(1), () => library.curve('auto', three)])
    assert.throws(call, { code: 'no_memory', message: /^found no memory left beside the 4000000000 bytes in use, wanted fewer curves at once/ });
});

test('an argument that is no number, or has code of its own, is no fault of the library', async () => {
  const library = await lite.load(), curve = library.curve('auto', three), same = curve.at(1);
  for (const time of [1n, Symbol('x'), { valueOf() { throw new Error('mine'); } }]) assert.equal(thrown(() => curve.at(time)).code, 'bad_argument');
  assert.deepEqual(curve.at(1), same);
  // The memory grows while the numbers are asked for.
  const asks = new Proxy(three.orientations, { get: (numbers, name) => (name === '5' && library.curve('auto', { times: Float64Array.from({ length: 1e5 }, (_, k) => k), orientations: Float64Array.from({ length: 4e5 }, (_, k) => (k % 4 === 3 ? 1 : 0)), order: 'xyzw' }).dispose(), numbers[name]) });
  assert.deepEqual(library.curve('auto', { ...three, orientations: asks }).at(1), same);
});

test('numbers may lie in any array, and samples from behind the end on are none', () => {
  const shared = new Float64Array(new SharedArrayBuffer(24)), same = ori.curve('auto', three).at(1.3);
  shared.set(three.times);
  for (const times of [shared, Float32Array.from(three.times), new (class extends Array {})(...three.times), new (class extends Float64Array { static get [Symbol.species]() { return Array; } })(three.times)])
    assert.deepEqual(ori.curve('auto', { ...three, times }).at(1.3), same);
  assert.equal(ori.curve('auto', three).sample({ start: 9, step: 0.1 }).times.length, 0);
});

test('a memory that grows changes nothing that the user has', async () => {
  const { library, exports } = await opened(lite.load), before = exports.memory.buffer.byteLength;
  const curve = library.curve('auto', three), samples = curve.sample({ step: 0.25, rates: 2 }), copy = structuredClone(samples), target = new Float64Array(4);
  const at = [...curve.at(1.3, target)], many = [];
  const times = Float64Array.from({ length: 1000 }, (_, k) => k), orientations = Float64Array.from({ length: 4000 }, (_, k) => (k % 4 === 3 ? 1 : 0));
  while (exports.memory.buffer.byteLength === before) many.push(library.curve('timed-c2', { times, orientations, order: 'xyzw' }));
  assert.deepEqual(samples, copy);
  assert.deepEqual([...target], at);
  assert.deepEqual([...curve.at(1.3, target)], at);
});

test('curves that were disposed of and keys that were refused leave no memory behind', async () => {
  const { library, exports } = await opened(lite.load), twice = { ...three, times: [0, 1, 1] };
  const work = (count) => {
    for (let k = 0; k < count; ++k) {
      library.curve('timed-c2', three, { tension: [0.5, 1, 0.5] }).dispose();
      if (k % 2) thrown(() => library.curve('auto', twice));
      else thrown(() => library.curve('timed-c2', three, { tension: 1e9 }));
    }
    return exports.memory.buffer.byteLength;
  };
  Error.stackTraceLimit = 0; // what takes most of the time
  assert.equal(work(100), work(100000));
  Error.stackTraceLimit = 10;
});

test('curves that are forgotten are freed', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc'), { library, exports } = await opened(lite.load);
  const times = Float64Array.from({ length: 2000 }, (_, k) => k), orientations = Float64Array.from({ length: 8000 }, (_, k) => (k % 4 === 3 ? 1 : 0));
  const forget = async () => {
    for (let k = 0; k < 20; ++k) library.curve('auto', { times, orientations, order: 'xyzw' });
    collect();
    await new Promise((done) => setTimeout(done, 5));
    return exports.memory.buffer.byteLength;
  };
  for (let k = 0; k < 5; ++k) await forget();
  const before = await forget();
  for (let k = 0; k < 20; ++k) await forget();
  assert.ok(exports.memory.buffer.byteLength <= 1.5 * before, `${before} bytes, then ${exports.memory.buffer.byteLength}`);
});
