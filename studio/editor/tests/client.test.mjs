// SPDX-License-Identifier: Apache-2.0
// The page's end of the worker, with a worker that answers when the test says so.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { engine, packed } from './engine.mjs';

class Puppet extends EventTarget {
  asked = [];
  postMessage(data) {
    this.asked.push(data);
  }
  terminate() {}
  answer(answered) {
    this.dispatchEvent(Object.assign(new Event('message'), { data: { number: this.asked.at(-1).number, ...answered } }));
    return new Promise(setImmediate);
  }
}

const begun = () => {
  const worker = new Puppet(), client = new engine.WorkerEngine(() => worker, 'text'), curves = [];
  client.onCurves((found, of) => curves.push([found, of]));
  return { worker, client, curves };
};
const documentOf = (name) => ({ name, keys: [1, 2] });

test('the worker is given the library, then questions', async () => {
  const { worker, client } = begun(), methods = client.ask('methods', null);
  assert.deepEqual(worker.asked, [{ library: 'text' }, { number: 1, name: 'methods', given: null }]);
  await worker.answer({ told: ['auto'] });
  assert.deepEqual(await methods, ['auto']);
  const refused = client.ask('bake', {});
  worker.answer({ trouble: { message: 'No.', key: 3 } });
  await assert.rejects(refused, { message: 'No.', key: 3 });
});

test('how far a task is is told, and to stop it another worker begins', async () => {
  const workers = [], shares = [], client = new engine.WorkerEngine(() => workers[workers.push(new Puppet()) - 1], 'text'), curves = [];
  client.onCurves((found, { name }) => curves.push(name));
  const reduced = client.ask('reduce', {}, (share) => shares.push(share)), drawn = documentOf('a');
  await workers[0].answer({ share: 0.25 });
  await workers[0].answer({ share: 0.5 });
  client.draw(drawn);
  client.stop();
  await assert.rejects(reduced, engine.stopped);
  await new Promise(setImmediate);
  assert.deepEqual([shares, workers.length, workers[1].asked.map(({ name, library }) => name ?? library)], [[0.25, 0.5], 2, ['text', 'curves']]);
  await workers[1].answer({ told: { first: { t: 1 }, second: { t: 2 } } });
  assert.deepEqual(curves, ['a']);
});

test('of documents that are drawn the newest is next, and no other waits', async () => {
  const { worker, client, curves } = begun(), names = () => worker.asked.slice(1).map(({ given }) => given.document.name);
  for (const name of ['a', 'b', 'c', 'd']) client.draw(documentOf(name));
  assert.deepEqual(names(), ['a']);
  await worker.answer({ told: { first: { t: 1 }, second: { t: 2 } } });
  assert.deepEqual(names(), ['a', 'd']);
  await worker.answer({ told: { first: { trouble: { message: 'No.' } }, second: 'same' } });
  assert.deepEqual(names(), ['a', 'd']);
  assert.deepEqual(curves.map(([found, { name }]) => [name, found]), [['a', { first: { t: 1 }, second: { t: 2 } }], ['d', { first: { trouble: { message: 'No.' } }, second: { t: 2 } }]]);
});

test('a worker that ends or cannot begin is told in a sentence', async () => {
  const { worker, client, curves } = begun(), waiting = client.ask('methods', null);
  worker.dispatchEvent(Object.assign(new Event('error', { cancelable: true }), { message: 'out of memory' }));
  await assert.rejects(waiting, { message: 'The worker with the library has ended: out of memory. Load the page again.' });
  client.draw(documentOf('a'));
  await new Promise(setImmediate);
  assert.match(curves[0][0].first.trouble.message, /has ended/);
  const none = new engine.WorkerEngine(() => { throw new Error('refused'); }, 'text');
  await assert.rejects(none.ask('methods', null), { message: /gives the page no worker/ });
  const closed = begun().client, asked = closed.ask('methods', null);
  closed.close();
  await assert.rejects(asked, { message: /was closed/ });
});

test('a browser that lacks what the library needs is told in a sentence', async (context) => {
  for (const text of ['', '__MARK__', btoa('no gzip')]) await assert.rejects(engine.moduleIn(text), { message: /so the page is not whole; take it anew/ });
  const { DecompressionStream, WebAssembly } = globalThis;
  context.after(() => Object.assign(globalThis, { DecompressionStream, WebAssembly }));
  globalThis.WebAssembly = { validate: () => false };
  await assert.rejects(engine.moduleIn(packed), { message: /found no WebAssembly with SIMD here/ });
  delete globalThis.DecompressionStream;
  await assert.rejects(engine.moduleIn(packed), { message: /cannot unpack the library/ });
});

test('the newest work is done next', async () => {
  const done = [], latest = new engine.Latest(async (work) => { done.push(work); await null; });
  for (const work of [1, 2, 3]) latest.put(work);
  await new Promise(setImmediate);
  latest.put(4);
  assert.deepEqual(done, [1, 3, 4]);
});
