// SPDX-License-Identifier: Apache-2.0
// What the package holds: its entries, its types, its notices, and how large its parts are for who loads them.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { brotliCompressSync, constants } from 'node:zlib';

const folder = process.env.ORISPLINE_NPM, here = import.meta.dirname;
const manifest = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
/** Without the compiler for WebAssembly the package has no modules. */
const isCompiled = readdirSync(folder).some((name) => name.endsWith('.wasm'));
const read = (...path) => readFileSync(join(...path), 'utf8');

test('every entry has a module and its types', () => {
  assert.ok(Object.keys(manifest.exports).length > 0);
  for (const [name, entry] of Object.entries(manifest.exports))
    for (const file of typeof entry === 'string' ? [entry] : Object.values(entry))
      assert.ok(existsSync(join(folder, file)) || (file.endsWith('.wasm') && !isCompiled), `${name}: ${file}`);
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
});

test('its types are those of tests/npm/expected', () => {
  const names = (place) => readdirSync(place).filter((name) => name.endsWith('.d.ts')).sort();
  assert.deepEqual(names(folder), names(join(here, 'expected')));
  for (const name of names(folder))
    assert.equal(read(folder, name), read(here, 'expected', name), `${name} differs, wanted: cp build/npm/*.d.ts tests/npm/expected`);
});

/** As servers send it. The best quality, 11, takes a second for 500 kB. */
const compressed = (bytes, quality = 11) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: quality } }).length;

for (const [part, { entry, module, quality, most }] of Object.entries(JSON.parse(read(here, 'sizes.json'))))
  test(`${part} is at most ${most} bytes, compressed by brotli`, { skip: module && !existsSync(join(folder, module)) && 'the module was not compiled; make web compiles it' }, async () => {
    const { build } = createRequire(join(process.env.ORISPLINE_NPM_TOOLS, 'x'))('esbuild');
    const { outputFiles } = await build({
      entryPoints: [join(folder, entry)], bundle: true, minify: true, format: 'esm', write: false, logLevel: 'silent', external: ['three'],
    });
    const sizes = [compressed(outputFiles[0].contents), module ? compressed(readFileSync(join(folder, module)), quality) : 0];
    console.log(`${part}: ${sizes[0]} bytes of script, ${sizes[1]} of WebAssembly`);
    assert.ok(sizes[0] + sizes[1] <= most, `${part}: found ${sizes[0] + sizes[1]} bytes, wanted at most ${most}`);
  });
