// SPDX-License-Identifier: Apache-2.0
// What the package holds: its entries, its types, its notices, and how large its parts are for who loads them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { isCompiled, parts, sizesOf } from './sizes.mjs';

const folder = process.env.ORISPLINE_NPM, here = import.meta.dirname;
const manifest = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
/** Without the compiler for WebAssembly the package has no modules. */
const hasModules = readdirSync(folder).some((name) => name.endsWith('.wasm'));
const read = (...path) => readFileSync(join(...path), 'utf8');

test('every entry has a module and its types', () => {
  assert.ok(Object.keys(manifest.exports).length > 0);
  for (const [name, entry] of Object.entries(manifest.exports))
    for (const file of typeof entry === 'string' ? [entry] : Object.values(entry))
      assert.ok(existsSync(join(folder, file)) || (file.endsWith('.wasm') && !hasModules), `${name}: ${file}`);
});

test('it asks for nothing else', () => {
  for (const part of ['dependencies', 'devDependencies', 'scripts', 'peerDependencies']) assert.equal(manifest[part], undefined, part);
  assert.deepEqual([manifest.type, manifest.sideEffects, manifest.license], ['module', false, 'Apache-2.0']);
});

test('its version is that of the project', () => {
  assert.equal(read(here, '../../CMakeLists.txt').match(/^\s+VERSION (\d+\.\d+\.\d+)/m)[1], manifest.version);
});

test('it holds the licence and the notices', () => {
  for (const file of ['LICENSE', 'NOTICE', 'THIRD_PARTY', 'README.md']) assert.ok(read(folder, file).length > 100, file);
  const linked = ['Eigen', 'fmt', 'tl::expected', 'fast_float', 'nlohmann-json', 'SIMDe', 'libc++', 'libc++abi', 'compiler-rt', 'wasi-libc', 'musl', 'cloudlibc', 'dlmalloc'];
  const named = [...read(folder, 'THIRD_PARTY').matchAll(/^(\S+) \(https:/gm)].map(([, name]) => name);
  assert.deepEqual(linked.filter((name) => !named.includes(name)), []);
});

test('its types are those of tests/npm/expected', () => {
  const names = (place) => readdirSync(place).filter((name) => name.endsWith('.d.ts')).sort();
  assert.deepEqual(names(folder), names(join(here, 'expected')));
  for (const name of names(folder))
    assert.equal(read(folder, name), read(here, 'expected', name), `${name} differs, wanted: cp build/npm/*.d.ts tests/npm/expected`);
});

test('a strict program in TypeScript knows its types', () => {
  const place = mkdtempSync(join(tmpdir(), 'orispline-types-')), at = join(place, 'node_modules/orispline');
  try {
    mkdirSync(join(place, 'node_modules'));
    symlinkSync(folder, at);
    writeFileSync(join(place, 'program.ts'), `
      import { load as loadLite, type Curve, type Samples, OrisplineError } from 'orispline/lite';
      import { load } from 'orispline';
      import { load as loadFull, type Options, type Outcome, type RateData } from 'orispline/full';
      import { player } from 'orispline/player';
      import { animate, bake } from 'orispline/three';

      const ori = await loadLite({ wasmUrl: 'lite.wasm' });
      const curve: Curve = ori.curve('auto', { times: [0, 1], orientations: new Float32Array(8), order: 'xyzw' }, { tension: [1, 2], ends: 'natural', closed: true });
      const target: Float64Array = curve.at(1, new Float64Array(4)), plain: number[] = curve.at(1);
      const samples: Samples = curve.sample({ step: 0.1, rates: 2 });
      const [times, values]: [Float32Array, Float32Array] = bake(curve, { tolerance: 1e-3 });
      const track = animate(ori, { name: 'a', times, values, ValueTypeName: 'quaternion', more: 1 }, 'squad'), more: number = track.more;
      const whole = (await load()).curve('least', { times, orientations: values, order: 'wxyz', signs: 'as-given' });
      const again = player(whole.bake({ tolerance: 1e-5 })), order: number = whole.continuity().order;
      const outcome: Outcome = (await loadFull()).run('reduce', { recording: { times, orientations: values, order: 'xyzw' } }, { tolerance: '1deg' });
      export const all = [target, plain, samples, more, again, order, outcome, OrisplineError];
      // @ts-expect-error the order is never guessed
      ori.curve('auto', { times, orientations: values });
      // @ts-expect-error lite has no baking
      curve.bake({ tolerance: 1 });

      // Tasks have the inputs and options of the list of tasks, in both spellings.
      const full = await loadFull(), recording = { times, orientations: values, order: 'xyzw' } as const, scene = { bytes: '', name: 'walk.bvh' };
      const gyro: RateData = full.run('smooth', { recording, gyro: { times: [0, 1], rates: [0, 0, 1, 0, 0, 1], epoch: '0.5' } }, { gyroNoise: '1deg/s', gyro_offset: '1ms', adapt: false }).rates[0];
      full.run('reduce', { recording: [recording, recording] }, { tolerance: '1deg', smooth: true, penalty: 'jerk' });
      full.run('difference', { first: scene, second: full.run('smooth', { recording: scene }).skeletons[0] }, { rate: 24 });
      full.run('align', { moved: gyro, fixed: gyro });
      const named: string = 'retime', loose: Options = { maxRate: '20deg/s' };
      full.run(named, { keys: recording }, loose);
      // @ts-expect-error there is no such task
      full.run('redce', { recording });
      // @ts-expect-error there is no such option
      full.run('reduce', { recording }, { tolerence: '1deg' });
      // @ts-expect-error nor such a word
      full.run('smooth', { recording }, { loss: 'hubert' });
      // @ts-expect-error nor such an input
      full.run('reduce', { keys: recording });
      // @ts-expect-error the input is of another kind
      full.run('tune', { keys: scene });
      // @ts-expect-error one is missing
      full.run('difference', { first: scene });
    `);
    execFileSync(process.execPath, [join(process.env.ORISPLINE_NPM_TOOLS, 'typescript/bin/tsc'), '--noEmit', '--strict', '--exactOptionalPropertyTypes', '--target', 'ES2022', '--lib', 'ES2022,DOM',
      '--module', 'ESNext', '--moduleResolution', 'bundler', '--types', '', join(place, 'program.ts')], { encoding: 'utf8', stdio: 'pipe' });
  } catch (error) {
    assert.fail(error.stdout ?? error);
  } finally {
    rmSync(place, { recursive: true });
  }
});

for (const part of parts)
  test(`${part.name} is at most ${part.most} bytes, compressed by brotli`, { skip: !isCompiled(folder, part) && 'the module was not compiled; make web compiles it' }, async () => {
    const { script, module } = await sizesOf(folder, process.env.ORISPLINE_NPM_TOOLS, part);
    console.log(`${part.name}: ${script} bytes of script, ${module} of WebAssembly`);
    assert.ok(script + module <= part.most, `${part.name}: found ${script + module} bytes, wanted at most ${part.most}`);
  });
