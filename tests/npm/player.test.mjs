// SPDX-License-Identifier: Apache-2.0
// The player beside `orispline sample` of the same keys: within the tolerance at every time, also at the ends of pieces and outside.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { runInNewContext } from 'node:vm';

const { player } = await import(join(process.env.ORISPLINE_NPM, 'player.js'));
const keys = join(import.meta.dirname, '../../examples/data/flight_keys.csv');
const folder = mkdtempSync(join(tmpdir(), 'orispline-player-'));
after(() => rmSync(folder, { recursive: true }));

const command = (...words) => execFileSync(process.env.ORISPLINE_COMMAND, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const bake = (input, name, ...options) => {
  command('bake', input, '-o', join(folder, name), '--quiet', ...options);
  return readFileSync(join(folder, name));
};

/** The flight without its positions: files of version 1. */
const turns = join(folder, 'turns.csv');
writeFileSync(turns, readFileSync(keys, 'utf8').split('\n').map((row) => (/^[-\dt]/.test(row) ? row.split(',').slice(0, 5).join(',') : row)).join('\n'));

/** The rows of numbers of the curve itself. */
const rowsOf = (input, method, times) => {
  writeFileSync(join(folder, 'times.txt'), times.join('\n') + '\n');
  const rows = command('sample', input, '--method', method, '--times', join(folder, 'times.txt'), '--quiet').split('\n');
  return rows.filter((row) => /^[-\d]/.test(row)).map((row) => row.split(',').map(Number));
};
/** The orientations of the curve itself, x, y, z, w. */
const sampled = (input, method, times) => rowsOf(input, method, times).map(([, w, x, y, z]) => [x, y, z, w]);

/** What the tolerance bounds: twice the distance in R⁴ [rad]. */
const apart = (one, other) => 2 * Math.hypot(...[0, 1, 2, 3].map((i) => one[i] - other[i]));

/** Even times from before the first key to behind the last one, the keys, and the ends of all pieces with what is just beside them. */
const timesOf = ({ ends, epoch }) => {
  const first = ends[0] + epoch, last = ends.at(-1) + epoch, length = last - first;
  const even = Array.from({ length: 2001 }, (_, k) => first - 0.1 * length + (1.2 * length * k) / 2000);
  const beside = ends.flatMap((end) => [end + epoch - 1e-6, end + epoch, end + epoch + 1e-6]);
  return [...even, ...beside, first - 1e9, last + 1e9];
};

for (const [method, tolerance] of [['auto', 1e-4], ['slerp', 1e-4], ['squad', 1e-3], ['timed-c2:tension=0.4', 1e-2], ['global-c2', 1e-4], ['auto', 1]])
  test(`${method} within ${tolerance}° from both files`, () => {
    const options = ['--method', method, '--tolerance', `${tolerance}deg`];
    const file = JSON.parse(bake(keys, 'curve.json', ...options)), bytes = bake(keys, 'curve.bin', ...options);
    const times = timesOf(file), wanted = sampled(keys, method, times), target = new Float64Array(4);
    for (const motion of [player(file), player(bytes), player(new Uint8Array(bytes).buffer)]) {
      assert.deepEqual([motion.start, motion.end], [0, 48]);
      let largest = 0;
      times.forEach((time, k) => (largest = Math.max(largest, apart(motion.at(time, target), wanted[k]))));
      assert.ok(largest <= (tolerance * Math.PI) / 180, `${largest} rad`);
    }
    const [one, other] = [player(file), player(bytes)];
    for (const time of times) assert.deepEqual(one.at(time), other.at(time));
  });

for (const [method, tolerance] of [['auto', 1e-3], ['slerp', 1e-2], ['timed-c2:tension=0.4', 1e-4], ['auto', 10]])
  test(`positions by ${method} within ${tolerance} m from both files`, () => {
    const options = ['--method', method, '--tolerance', '1deg', '--position-tolerance', `${tolerance}m`];
    const file = JSON.parse(bake(keys, 'curve.json', ...options)), bytes = bake(keys, 'curve.bin', ...options);
    const times = timesOf({ ...file, ends: file.position_ends }), header = readFileSync(keys, 'utf8').split('\n').find((row) => row.startsWith('t,')).split(',');
    assert.equal(file.version, 2);
    const wanted = rowsOf(keys, method, times), at = header.indexOf('px'), [one, other] = [player(file), player(bytes)], target = [0, 0, 0];
    assert.ok(one.hasPositions && other.hasPositions);
    times.forEach((time, k) => {
      const place = wanted[k].slice(at, at + 3), played = one.positionAt(time, target);
      const off = Math.hypot(...place.map((x, i) => x - played[i]));
      assert.ok(off <= tolerance, `${off} m at ${time}`);
      assert.deepEqual([...played], other.positionAt(time));
    });
    assert.ok(one.positionAt(NaN).every(Number.isNaN));
  });

test('positions far from 0 keep their digits, and those of another clock their ends', () => {
  const far = join(folder, 'far.csv'), x = 431234.56789, y = 5567891.23456; // as UTM has them [m]
  writeFileSync(far, `t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,${x},${y},10\n1,0.8,0.6,0,0,${x + 1},${y},10.5\n2,0.6,0,0.8,0,${x + 2},${y + 1},11\n`);
  const motion = player(bake(far, 'far.bin', '--tolerance', '1deg', '--position-tolerance', '0.1mm'));
  for (const [k, [px, py, pz]] of [[x, y, 10], [x + 1, y, 10.5], [x + 2, y + 1, 11]].entries()) {
    const place = motion.positionAt(k);
    assert.ok(Math.hypot(place[0] - px, place[1] - py, place[2] - pz) <= 1e-4, `${place}`);
  }
});

test('a file without positions says so', () => {
  const motion = player(bake(turns, 'turns.bin', '--tolerance', '1deg'));
  assert.equal(motion.hasPositions, false);
  assert.throws(() => motion.positionAt(1), { message: "orispline/player: found a file without positions, wanted what 'orispline bake' writes of keys that have them" });
});

test('it finds the piece whatever time came before', () => {
  const bytes = bake(keys, 'curve.bin', '--tolerance', '1e-3deg'), motion = player(bytes);
  let seed = 1;
  for (let k = 0; k < 2000; ++k) {
    seed = (seed * 48271) % 2147483647;
    const time = (60 * seed) / 2147483647 - 6;
    assert.deepEqual(motion.at(time), player(bytes).at(time));
  }
});

test('times are those of the file, as exact as they are there', () => {
  const late = join(folder, 'late.csv');
  writeFileSync(late, 't,qw,qx,qy,qz\n1700000000.25,1,0,0,0\n1700000001,0.8,0.6,0,0\n1700000002.5,0.6,0,0.8,0\n');
  const file = JSON.parse(bake(late, 'curve.json', '--tolerance', '1e-4deg')), motion = player(file);
  assert.deepEqual([motion.start, motion.end], [1700000000.25, 1700000002.5]);
  const times = [1700000000, 1700000000.5, 1700000001, 1700000002.4375, 1700000003];
  sampled(late, 'auto', times).forEach((wanted, k) => assert.ok(apart(motion.at(times[k]), wanted) < 1.8e-6));
});

test('a single key is held', () => {
  const one = join(folder, 'one.csv');
  writeFileSync(one, 't,qw,qx,qy,qz\n2,0,0,1,0\n');
  for (const time of [-1, 2, 5]) assert.deepEqual(player(bake(one, 'curve.bin', '--tolerance', '1deg')).at(time), [0, 1, 0, 0]);
});

test('the loop of docs/web.md plays a single key, and others again and again', () => {
  const one = join(folder, 'one.csv'), loop = /const time = (motion\.start.*?);/.exec(readFileSync(join(import.meta.dirname, '../../docs/web.md'), 'utf8'))[1];
  const timeOf = new Function('motion', 'now', `return ${loop}`);
  writeFileSync(one, 't,qw,qx,qy,qz\n2,0,0,1,0\n');
  const still = player(bake(one, 'one.bin', '--tolerance', '1deg')), motion = player(bake(keys, 'curve.bin', '--tolerance', '1deg'));
  for (const now of [0, 16.7, 1e6]) assert.deepEqual(still.at(timeOf(still, now)), [0, 1, 0, 0]);
  assert.deepEqual([0, 47000, 49000].map((now) => timeOf(motion, now)), [0, 47, 1]);
});

test('bytes may be those of another realm', () => {
  const bytes = bake(keys, 'curve.bin', '--tolerance', '1deg'), same = player(bytes).at(3);
  for (const made of ['new Uint8Array(bytes)', 'new Uint8Array(bytes).buffer', 'new DataView(new Uint8Array(bytes).buffer)'])
    assert.deepEqual(player(runInNewContext(made, { bytes })).at(3), same);
  assert.deepEqual(player(runInNewContext('JSON.parse(text)', { text: bake(keys, 'curve.json', '--tolerance', '1deg').toString() })).at(3), same);
});

test('times and targets that are none are refused in one sentence', () => {
  const motion = player(bake(keys, 'curve.bin', '--tolerance', '1deg')), wanted = 'wanted a number and an array';
  for (const [time, target, found] of [[undefined, [], 'the time undefined and a target that is object'], ['1', [], 'the time 1 and'], [1n, [], 'the time 1 and'], [Symbol('x'), [], 'the time Symbol(x) and'],
    [1, null, 'the time 1 and a target that is object'], [1, 'abc', 'the time 1 and a target that is string'], [1, 5, 'the time 1 and a target that is number']]) {
    const text = (() => { try { motion.at(time, target); } catch (error) { return error.message; } })();
    assert.ok(text.startsWith(`orispline/player: found ${found}`) && text.endsWith(wanted), text);
  }
});

test('the target is what was given, and NaN gives NaN', () => {
  const motion = player(bake(keys, 'curve.bin', '--tolerance', '1deg')), target = new Float32Array(4);
  assert.equal(motion.at(1, target), target);
  assert.ok(Array.from(motion.at(NaN)).every(Number.isNaN));
  assert.equal(motion.at(3).length, 4);
});

test('what is no baked curve is refused in one sentence', () => {
  const bytes = bake(turns, 'curve.bin', '--tolerance', '1deg'), file = JSON.parse(bake(turns, 'curve.json', '--tolerance', '1deg'));
  const newer = Uint8Array.from(bytes);
  newer[8] = 3;
  const wanted = "wanted version 1 or 2 of what 'orispline bake' writes";
  for (const [given, found] of [
    [new ArrayBuffer(0), 'other bytes'], [new TextEncoder().encode(JSON.stringify(file)), 'other bytes'], [newer, 'version 3'],
    [bytes.subarray(0, bytes.length - 4), `${bytes.length - 4} bytes for 37 pieces`], [{}, 'another object'], [null, 'another object'],
    [{ byteLength: 0, length: 1e9 }, 'another object'], [{ byteLength: 0 }, 'another object'],
    [{ ...file, version: 7 }, 'version 7'], [{ ...file, ends: [0, 1] }, '888 coefficients for 2 ends'], [{ ...file, ends: [], pieces: [] }, '0 coefficients for 0 ends'],
  ])
    assert.throws(() => player(given), { message: `orispline/player: found ${found}, ${wanted}` });
});

test('a file that was tampered with is refused, wherever', () => {
  const bytes = bake(turns, 'curve.bin', '--tolerance', '1deg'), file = JSON.parse(bake(turns, 'curve.json', '--tolerance', '1deg'));
  const changed = (change) => {
    const copy = structuredClone(file);
    change(copy);
    return copy;
  };
  const written = (write) => {
    const copy = Uint8Array.from(bytes);
    write(new DataView(copy.buffer));
    return copy;
  };
  const count = file.pieces.length, ends = 32, coefficients = 40 + 8 * count;
  /** As a machine of the other order of bytes has them. */
  const turned = (from, to, width) => written((view) => {
    for (let at = from; at < to; at += width) new Uint8Array(view.buffer, at, width).reverse();
  });
  const notFinite = 'what is no finite number', notIncreasing = 'ends that do not increase', noLists = 'no lists of ends and pieces';
  for (const [given, found] of [
    [changed((one) => (one.order = 'wxyz')), 'the order wxyz'], [changed((one) => delete one.order), 'the order undefined'],
    [changed((one) => delete one.pieces), noLists], [changed((one) => delete one.ends), noLists], [changed((one) => (one.ends = 'abc')), noLists],
    [changed((one) => (one.pieces = {})), noLists], [changed((one) => delete one.epoch), notFinite], [changed((one) => (one.epoch = '5')), notFinite],
    [changed((one) => (one.ends[3] = null)), notFinite], [changed((one) => (one.pieces[4][7] = null)), notFinite], [changed((one) => (one.pieces[4][7] = '1')), notFinite],
    [changed((one) => (one.pieces[4][7] = 1e39)), notFinite], [changed((one) => one.ends.reverse()), notIncreasing], [changed((one) => (one.ends[3] = one.ends[2])), notIncreasing],
    [changed((one) => one.pieces.push(one.pieces.pop().slice(1))), `${24 * count - 1} coefficients for ${count + 1} ends`],
    [changed((one) => one.pieces[1].push(one.pieces[0].pop())), `${24 * count} coefficients for ${count + 1} ends`],
    [changed((one) => one.pieces.push([])), `${24 * count} coefficients for ${count + 1} ends`],
    [written((view) => view.setFloat64(16, NaN, true)), notFinite], [written((view) => view.setFloat64(ends + 8, NaN, true)), notFinite],
    [written((view) => view.setFloat32(coefficients, Infinity, true)), notFinite], [written((view) => view.setFloat64(ends + 8, 1e9, true)), notIncreasing],
    [changed((one) => ([one.ends[0], one.ends[count]] = [-1.7e308, 1.7e308])), notFinite], [changed((one) => (one.epoch = one.ends[count] = 1.7e308)), notFinite],
    [written((view) => (view.setFloat64(ends, -1.7e308, true), view.setFloat64(coefficients - 8, 1.7e308, true))), notFinite],
    [turned(8, 12, 4), 'version 16777216'], [turned(ends, coefficients, 8), notIncreasing], [turned(coefficients, bytes.length, 4), notFinite],
    [written((view) => view.setUint32(12, 0, true)).subarray(0, 40), '40 bytes for 0 pieces'],
    [written((view) => view.setUint32(8, 2, true)), `${bytes.length} bytes for ${count} pieces`], [changed((one) => (one.version = 2)), noLists],
  ])
    assert.throws(() => player(given), { message: `orispline/player: found ${found}, wanted version 1 or 2 of what 'orispline bake' writes` });
});

test('positions that were tampered with are refused', () => {
  const bytes = bake(keys, 'curve.bin', '--tolerance', '1deg'), file = JSON.parse(bake(keys, 'curve.json', '--tolerance', '1deg'));
  const changed = (change) => {
    const copy = structuredClone(file);
    change(copy);
    return copy;
  };
  const second = 40 + 104 * file.pieces.length, pieces = file.position_pieces.length;
  const written = (write) => {
    const copy = Uint8Array.from(bytes);
    write(new DataView(copy.buffer));
    return copy;
  };
  const notFinite = 'what is no finite number', notIncreasing = 'ends that do not increase', noLists = 'no lists of ends and pieces';
  for (const [given, found] of [
    [changed((one) => delete one.position_ends), noLists], [changed((one) => delete one.position_pieces), noLists],
    [changed((one) => (one.position_pieces[1][6] = '2')), notFinite], [changed((one) => (one.position_pieces[1][5] = 1e39)), notFinite],
    [changed((one) => one.position_pieces[0].pop()), `${18 * pieces - 1} coefficients for ${pieces + 1} ends`], [changed((one) => one.position_ends.reverse()), notIncreasing],
    [written((view) => view.setUint32(second, 0, true)), `${bytes.length} bytes for 0 pieces`], [written((view) => view.setUint32(second, 2 ** 32 - 1, true)), `${bytes.length} bytes for ${2 ** 32 - 1} pieces`],
    [written((view) => view.setFloat64(second + 16, NaN, true)), notFinite], [written((view) => view.setFloat64(second + 40, Infinity, true)), notFinite],
    [written((view) => view.setUint32(8, 1, true)), `${bytes.length} bytes for ${file.pieces.length} pieces`],
  ])
    assert.throws(() => player(given), { message: `orispline/player: found ${found}, wanted version 1 or 2 of what 'orispline bake' writes` });
});
