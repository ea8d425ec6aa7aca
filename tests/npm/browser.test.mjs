// SPDX-License-Identifier: Apache-2.0
// The package in Chromium, as it is and as a bundle of esbuild: what a page gets is what Node gets, bit for bit.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, extname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { command, entry, flight, keysFile } from './flight.mjs';
import { cases, differencesFrom } from './cases.mjs';

const tools = createRequire(join(process.env.ORISPLINE_NPM_TOOLS, 'x'));
const { chromium } = tools('playwright-core'), { build } = tools('esbuild');
const types = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };
const bundles = new Map();
let browser, server, page;

/** The files of the package, an empty page, and bundles. */
const answer = async ({ url }, response) => {
  const name = url.slice(1) || 'empty.html', { [extname(name)]: type = 'application/octet-stream' } = types;
  const content = name === 'empty.html' ? '<!doctype html><title>orispline</title>' : (bundles.get(name) ?? (await readFile(join(process.env.ORISPLINE_NPM, name)).catch(() => null)));
  response.writeHead(content ? 200 : 404, { 'content-type': type });
  response.end(content);
};

before(async () => {
  server = createServer(answer).listen(0, '127.0.0.1');
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] });
  page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** What a page and Node have in common: a module of the package, and what it makes of the flight. */
const motionOf = async ({ load }, keys, method) => {
  const curve = (await load()).curve(method, keys), samples = curve.sample({ step: 0.25, rates: 3 });
  return JSON.stringify([curve.at(17.3), curve.motion(17.3), Object.entries(samples).map(([name, numbers]) => [name, ...numbers])]);
};

for (const [name, method] of [['lite', 'auto'], ['lite', 'squad'], ['inline', 'timed-c2'], ['index', 'global-c2'], ['index', 'circular'], ['full', 'rotation-spline']])
  test(`${name} gives by ${method} what it gives in Node`, async () => {
    const there = await page.evaluate(`(async () => (${motionOf})(await import('./${name}.js'), ${JSON.stringify(flight)}, '${method}'))()`);
    assert.equal(there, await motionOf(await entry(name), flight, method));
  });

for (const [name, bulk] of [['lite', false], ['index', true], ['full', true]])
  test(`${name} gives what the cases of the C interface say, bit for bit`, async () => {
    const found = await page.evaluate(`(async () => (${differencesFrom})(${JSON.stringify(cases)}, await (await import('./${name}.js')).load(), ${bulk}))()`);
    assert.deepEqual(found, []);
  });

test('a worker makes curves of a module that its page has compiled', async () => {
  const at = await page.evaluate(`(async () => {
    const code = "import { load } from '" + location.origin + "/lite.js'; onmessage = async ({ data: [wasm, keys] }) => postMessage((await load({ wasm })).curve('auto', keys).at(17.3));";
    const worker = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })), { type: 'module' });
    const told = new Promise((done, fail) => ((worker.onmessage = ({ data }) => done(data)), (worker.onerror = fail)));
    worker.postMessage([await WebAssembly.compileStreaming(fetch('lite.wasm')), ${JSON.stringify(flight)}]);
    return told;
  })()`);
  assert.deepEqual(at, (await (await entry('lite')).load()).curve('auto', flight).at(17.3));
});

test('the player plays in a page', async () => {
  const file = command('bake', keysFile, '--tolerance', '1e-4deg', '--quiet');
  const there = await page.evaluate(`(async () => (await import('./player.js')).player(${file}).at(17.3))()`);
  assert.deepEqual(there, (await entry('player')).player(JSON.parse(file)).at(17.3));
});

for (const [what, wasmUrl, reason] of [['a file that is not there', 'no/such.file', '404'], ['a page in the place of the file', 'empty.html', 'text/html']])
  test(`${what} is told in one sentence`, async () => {
    const said = await page.evaluate(`(async () => (await import('./lite.js')).load({ wasmUrl: '${wasmUrl}' }).catch(({ code, message }) => [code, message]))()`);
    assert.deepEqual(said, ['bad_access', `${wasmUrl}: found no WebAssembly there (${reason}), wanted the .wasm of this package: give its place as wasmUrl`]);
  });

for (const [what, code] of [
  ['wasmUrl', "import wasmUrl from './lite.wasm'; import { load } from './lite.js'; globalThis.made = load({ wasmUrl });"],
  ['inline', "import { load } from './inline.js'; globalThis.made = load();"],
])
  test(`a bundle of esbuild works by ${what}`, async () => {
    const { outputFiles } = await build({
      stdin: { contents: code, resolveDir: process.env.ORISPLINE_NPM }, bundle: true, minify: true, format: 'esm', write: false, outdir: process.env.ORISPLINE_NPM,
      entryNames: `bundle-${what}`, loader: { '.wasm': 'file' }, logLevel: 'silent',
    });
    for (const { path, contents } of outputFiles) bundles.set(path.slice(dirname(path).length + 1), Buffer.from(contents));
    const at = await page.evaluate(`(async () => { await import('./bundle-${what}.js'); return (await made).curve('auto', ${JSON.stringify(flight)}).at(17.3); })()`);
    assert.deepEqual(at, (await (await entry('lite')).load()).curve('auto', flight).at(17.3));
  });
