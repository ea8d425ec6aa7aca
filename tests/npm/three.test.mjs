// SPDX-License-Identifier: Apache-2.0
// Tracks of three.js itself, moved by its own mixer.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { apart, command, entry, flight, rowsOf, three as keys, thrown } from './flight.mjs';

const THREE = await import(join(process.env.ORISPLINE_NPM_TOOLS, 'three/build/three.module.js'));
const { player } = await entry('player'), { animate, bake } = await entry('three'), ori = await (await entry('lite')).load();

const turned = flight.orientations.map((_, k) => flight.orientations[4 * Math.floor(k / 4) + [1, 2, 3, 0][k % 4]]);
const turns = () => new THREE.QuaternionKeyframeTrack('.quaternion', flight.times, turned);
const moves = () => new THREE.VectorKeyframeTrack('.position', flight.times, flight.positions);
/** The keys as a track has them, in single precision. */
const rounded = { times: Float32Array.from(flight.times), orientations: Float32Array.from(turned), positions: Float32Array.from(flight.positions), order: 'xyzw' };

/** Where the mixer of three.js takes an object at these times. */
const played = (clip, times) => {
  const object = new THREE.Object3D(), mixer = new THREE.AnimationMixer(object);
  mixer.clipAction(clip).setLoop(THREE.LoopOnce).play();
  return times.map((time) => (mixer.setTime(time), [object.quaternion.toArray(), object.position.toArray()]));
};

const times = Array.from({ length: 200 }, (_, k) => 0.2399 * k);

for (const method of ['auto', 'squad', 'timed-c2'])
  test(`a mixer moves an object by ${method}, exactly, also by a clone of its clip`, () => {
    const clip = new THREE.AnimationClip('flight', -1, [animate(ori, turns(), method), animate(ori, moves(), method)]);
    const curve = ori.curve(method, rounded);
    for (const one of [clip, clip.clone()])
      played(one, times).forEach(([quaternion, position], k) => {
        assert.ok(apart(quaternion, curve.at(times[k])) < 1e-12, `${times[k]}`);
        assert.ok(apart(position, curve.motion(times[k]).position) < 1e-9);
      });
  });

test('settings shape the curve, and what is done to a clone changes its curve alone', () => {
  const track = animate(ori, turns(), 'timed-c2', { tension: 0.2 }), clone = track.clone().shift(5);
  const at = (one, time) => [...one.createInterpolant().evaluate(time)];
  assert.deepEqual(at(track, 10), ori.curve('timed-c2', rounded, { tension: 0.2 }).at(10));
  assert.ok(apart(at(clone, 15), at(track, 10)) < 1e-5);
});

test('keys and tracks that cannot be are refused at once', () => {
  const twice = new THREE.QuaternionKeyframeTrack('.quaternion', [0, 1, 1], keys.orientations);
  assert.equal(thrown(() => animate(ori, twice)).key, 2);
  assert.equal(thrown(() => animate(ori, turns(), 'sqad')).message, "unknown method 'sqad'; did you mean 'squad'?");
  const color = new THREE.ColorKeyframeTrack('.color', [0, 1], [0, 0, 0, 1, 1, 1]);
  assert.equal(thrown(() => animate(ori, color)).message, 'track: found .color of the type color, wanted a quaternion or a vector');
});

/** What is told on the console meanwhile. */
const warnedBy = async (work) => {
  const { warn } = console, said = [];
  console.warn = (...words) => said.push(words.join(' '));
  try {
    await work();
  } finally {
    console.warn = warn;
  }
  return said;
};

/** An instance of the entry that has warned of nothing yet. */
const fresh = async (name) => (await import(`${join(process.env.ORISPLINE_NPM, 'three.js')}?${name}`)).animate;

test('a track that moves exactly says so where three.js writes it, once, and not before', async () => {
  globalThis.FileReader ??= class {
    readAsDataURL(blob) {
      blob.arrayBuffer().then((bytes) => ((this.result = `data:;base64,${Buffer.from(bytes).toString('base64')}`), this.onloadend()));
    }
  };
  const { GLTFExporter } = await import(join(process.env.ORISPLINE_NPM_TOOLS, 'three/examples/jsm/exporters/GLTFExporter.js'));
  const exported = (clip) => new GLTFExporter().parseAsync(new THREE.Object3D(), { animations: [clip] });
  const ways = { toJSON: (clip) => THREE.AnimationClip.toJSON(clip), clone: (clip) => clip.clone().toJSON(), exporter: exported, optimize: (clip) => clip.tracks.forEach((track) => track.optimize()) };
  for (const [name, write] of Object.entries(ways)) {
    const moves = await fresh(name), clip = new THREE.AnimationClip('flight', -1, [moves(ori, turns(), 'auto'), moves(ori, turns(), 'squad')]);
    assert.deepEqual(await warnedBy(() => played(clip.clone(), times)), []);
    const said = await warnedBy(async () => (await write(clip), await write(clip)));
    assert.deepEqual(said, ['orispline/three: found the track .quaternion, which animate() moves, written or optimised by three.js, which takes slerp for its curve; wanted a track of bake()'], name);
  }
});

test('a track whose interpolation was changed again is one of three.js', async () => {
  const track = (await fresh('changed'))(ori, turns(), 'auto').setInterpolation(THREE.InterpolateLinear);
  assert.deepEqual(await warnedBy(() => [THREE.KeyframeTrack.toJSON(track), THREE.KeyframeTrack.toJSON(track.clone())]), []);
  assert.equal(track.clone().getInterpolation(), THREE.InterpolateLinear);
  const twice = animate(ori, animate(ori, turns(), 'auto'), 'squad').clone();
  assert.deepEqual([...twice.createInterpolant().evaluate(10)], ori.curve('squad', rounded).at(10));
});

for (const tolerance of [1e-2, 1e-3])
  test(`a baked track is within ${tolerance} rad of the curve, by three's own slerp`, () => {
    const curve = ori.curve('auto', { ...flight, order: 'xyzw', orientations: turned }), [at, values] = bake(curve, { tolerance });
    const clip = new THREE.AnimationClip('flight', -1, [new THREE.QuaternionKeyframeTrack('.quaternion', at, values)]);
    const fine = Array.from({ length: 4000 }, (_, k) => 0.012 * k);
    const off = Math.max(...played(clip, fine).map(([q], k) => new THREE.Quaternion(...q).angleTo(new THREE.Quaternion(...curve.at(fine[k])))));
    assert.ok(off <= tolerance + 2e-6, `${off} rad`);
    const least = { 1e-2: 80, 1e-3: 255 }[tolerance];
    console.log(`${at.length} keys within ${tolerance} rad`);
    assert.ok(at.length < least, `${at.length} keys`);
    assert.deepEqual([at[0], at.at(-1)], [0, 48]);
  });

test('times that a track cannot hold are refused, and those that it can are hit', () => {
  const late = (start) => ori.curve('auto', { ...keys, times: keys.times.map((time) => start + time) });
  assert.equal(thrown(() => bake(late(1.7e9), { tolerance: 1e-3 })).message,
    'curve: found times from 1700000000 to 1700000002.5 s, which a track holds in steps of 128 s, wanted some that count from near 0');
  const curve = late(1000), [times, values] = bake(curve, { tolerance: 1e-2 });
  const clip = new THREE.AnimationClip('late', -1, [new THREE.QuaternionKeyframeTrack('.quaternion', times, values)]);
  const fine = Array.from({ length: 500 }, (_, k) => 1000 + 0.005 * k);
  const off = Math.max(...played(clip, fine).map(([q], k) => new THREE.Quaternion(...q).angleTo(new THREE.Quaternion(...curve.at(fine[k])))));
  assert.ok(off <= 1e-2 + 2e-6, `${off} rad`);
});

test('a steady turn needs its two ends, and a single key itself', () => {
  const steady = { times: [0, 1, 2], orientations: [0, 0, 0, 1, 0, 0, Math.sin(0.5), Math.cos(0.5), 0, 0, Math.sin(1), Math.cos(1)], order: 'xyzw' };
  assert.equal(bake(ori.curve('slerp', steady), { tolerance: 1e-5 })[0].length, 2);
  assert.equal(bake(ori.curve('slerp', { times: [3], orientations: [0, 0, 0, 1], order: 'xyzw' }), { tolerance: 1e-5 })[0].length, 1);
});

test('tolerances that a track cannot hold are refused, and the other order', () => {
  const curve = ori.curve('auto', keys);
  assert.equal(thrown(() => bake(curve, { tolerance: 0 })).message, 'tolerance: found 0 rad, wanted 0.000001 rad or more, which is what a track holds');
  assert.equal(thrown(() => bake(ori.curve('auto', { ...keys, order: 'wxyz' }), { tolerance: 1 })).option, 'curve');
});

const folder = mkdtempSync(join(tmpdir(), 'orispline-three-'));
after(() => rmSync(folder, { recursive: true }));
const flown = join(folder, 'camera.glb');
command('sample', join(import.meta.dirname, '../../examples/data/camera_keys.csv'), '-o', flown, '--tolerance', '0.01deg', '--quiet');
const ofOthers = join(import.meta.dirname, '../../../shared/cases/clips/18_camera.glb');

for (const file of [flown, ofOthers].filter(existsSync))
  test(`a camera flies as ${file.split('/').at(-1)} says`, () => {
    const name = join(folder, 'flight.bin');
    command('bake', file, '--tolerance', '0.001deg', '--position-tolerance', '0.1mm', '-o', name, '--quiet');
    const motion = player(readFileSync(name)), camera = new THREE.PerspectiveCamera(), q = [0, 0, 0, 1], p = [0, 0, 0];
    assert.ok(motion.hasPositions);
    for (const [time, w, x, y, z, ...place] of rowsOf(command('sample', file, '--method', 'auto', '--count', '500', '--quiet'))) {
      camera.quaternion.fromArray(motion.at(time, q)).normalize();
      camera.position.fromArray(motion.positionAt(time, p));
      assert.ok(camera.quaternion.angleTo(new THREE.Quaternion(x, y, z, w)) < 2e-5, `${time}`);
      assert.ok(camera.position.distanceTo(new THREE.Vector3(...place.slice(0, 3))) < 1e-4, `${time}`);
    }
    assert.deepEqual(motion.positionAt(motion.end + 5), motion.positionAt(motion.end));
  });
