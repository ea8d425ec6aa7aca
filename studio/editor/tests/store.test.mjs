// SPDX-License-Identifier: Apache-2.0
// The document as it is edited: steps, gestures, what is saved, which key is chosen; and the draft of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dice, documentOf, keysOfAngles, moduleOf, shoemake, tcb, tension, timedC2 } from './modules.mjs';

const edits = ['turn', 'time', 'keys', 'position', 'parameters', 'choice'].map((name) => `edits/${name}.ts`);
const { Draft, createStore, draftIn, draftText, ...edit } = await moduleOf('store/store.ts', 'store/draft.ts', 'store/draftText.ts', ...edits);

const four = documentOf(keysOfAngles([0, 0.5, 1, 1.5]));
const turn = (store, angle, gesture) => store.edit(edit.turnedInWorld(store.current().document, 2, [0, 0, angle]), gesture);

test('a store tells those who asked for what changed, and nobody else', () => {
  const store = createStore(four);
  const told = { document: 0, chosen: 0 };
  store.subscribe(['document'], () => told.document++);
  const end = store.subscribe(['chosen'], () => told.chosen++);
  assert.deepEqual(told, { document: 1, chosen: 1 });
  turn(store, 0.1);
  store.choose(3);
  store.choose(3);
  end();
  store.choose(2);
  assert.deepEqual(told, { document: 2, chosen: 2 });
});

test('undo and redo go through all documents that there were', () => {
  const store = createStore(four);
  const seen = [four];
  for (const angle of [0.1, 0.2, 0.3]) {
    turn(store, angle);
    seen.push(store.current().document);
  }
  for (const document of seen.toReversed().slice(1)) {
    store.undo();
    assert.equal(store.current().document, document);
  }
  assert.deepEqual([store.current().canUndo, store.current().canRedo], [false, true]);
  store.undo();
  assert.equal(store.current().document, four);
  for (const document of seen.slice(1)) {
    store.redo();
    assert.equal(store.current().document, document);
  }
  assert.deepEqual([store.current().canUndo, store.current().canRedo], [true, false]);
});

test('an edit ends what could be done again', () => {
  const store = createStore(four);
  turn(store, 0.1);
  store.undo();
  turn(store, 0.2);
  assert.equal(store.current().canRedo, false);
});

test('an edit that changes nothing is no step, and leaves what could be done again', () => {
  const store = createStore(four);
  turn(store, 0.1);
  store.undo();
  store.edit(structuredClone(four));
  assert.deepEqual([store.current().canUndo, store.current().canRedo, store.current().isSaved], [false, true, true]);
});

test('a gesture is one step', () => {
  const store = createStore(four);
  const gesture = {};
  for (let i = 0; i < 50; i++) turn(store, 0.01, gesture);
  turn(store, 0.3, {});
  store.undo();
  store.undo();
  assert.equal(store.current().document, four);
});

test('a gesture that ends where it began leaves no step, and may go on', () => {
  const store = createStore(four);
  turn(store, 0.5);
  store.undo();
  const gesture = {};
  turn(store, 0.1, gesture);
  store.edit(structuredClone(four), gesture);
  assert.deepEqual([store.current().canUndo, store.current().canRedo], [false, true]);
  turn(store, 0.2, gesture);
  turn(store, 0.2, gesture);
  store.undo();
  assert.equal(store.current().document, four);
});

test('what is saved is told by content', () => {
  const store = createStore(four);
  turn(store, 0.1);
  assert.equal(store.current().isSaved, false);
  store.edit(structuredClone(four));
  assert.equal(store.current().isSaved, true);
  turn(store, 0.2);
  store.tellSaved();
  assert.equal(store.current().isSaved, true);
  store.undo();
  assert.equal(store.current().isSaved, false);
  store.redo();
  assert.equal(store.current().isSaved, true);
});

test('the chosen key stays chosen; where it is no more, the one by time is', () => {
  const store = createStore(four);
  const { document, id } = edit.duplicated(four, 3);
  store.edit(document);
  store.choose(id);
  turn(store, 0.1);
  assert.equal(store.current().chosen, id);
  store.undo();
  assert.equal(store.current().chosen, id);
  store.undo();
  assert.equal(store.current().chosen, 3);
  store.choose(99);
  assert.equal(store.current().chosen, null);
});

test('troubles are those of the newest curves', () => {
  const store = createStore(four);
  let told = 0;
  store.subscribe(['troubles'], () => told++);
  const trouble = { message: 'found 4 keys, wanted more' };
  store.tellCurves({ first: { trouble }, second: {} });
  store.tellCurves({ first: { trouble: { ...trouble } }, second: {} });
  assert.deepEqual(store.current().troubles, { first: trouble, second: null });
  assert.equal(told, 2);
  store.tellCurves({ first: {}, second: {} });
  assert.deepEqual(store.current().troubles, { first: null, second: null });
});

/** One of the edits, drawn. */
function drawnEdit(store, random) {
  const { document } = store.current();
  const { id, t } = document.keys[Math.floor(random() * document.keys.length)];
  const [a, b, c] = [random() - 0.5, random() - 0.5, random() - 0.5];
  const which = random() < 0.5 ? 'first' : 'second';
  const method = [timedC2, tcb, shoemake][Math.floor(random() * 3)];
  const ways = [
    () => edit.turnedInWorld(document, id, [4 * a, 4 * b, 4 * c]),
    () => edit.turnedInBody(document, id, [a, b, c]),
    () => edit.turnedTo(document, id, [a, b, c, random()]),
    () => edit.movedInTime(document, id, t + 2 * a),
    () => edit.inserted(document, t + a, { q: [a, b, c, 1], p: [a, b, c] }).document,
    () => edit.duplicated(document, id).document,
    () => edit.deleted(document, id),
    () => edit.placed(document, id, 1, 10 * a),
    () => edit.withOwn(document, id, which, tension, 2 * a),
    () => edit.withValueForAll(document, which, tension, b),
    () => edit.withoutOwn(document, 'tension'),
    () => edit.withMethod(document, which, method),
    () => edit.withSetting(document, which, method, 'ends', 'natural'),
  ];
  return ways[Math.floor(random() * ways.length)]();
}

const sound = ({ keys }) => keys.every((key, i) => i === 0 || (keys[i - 1].t < key.t && keys[i - 1].q.reduce((sum, number, k) => sum + number * key.q[k], 0) >= 0));

test('thirty random walks of 200 edits: undo leads to the start, redo to the end', () => {
  for (let seed = 1; seed <= 30; seed++) {
    const random = dice(seed);
    const start = documentOf(keysOfAngles([0, 0.5, 1, 1.5, 2.5], (i) => ({ p: [i, 0, 0], rates: [[0, 0, 1]] })));
    const copy = structuredClone(start);
    const store = createStore(start);
    let gesture;
    for (let i = 0; i < 200; i++) {
      gesture = random() < 0.3 ? gesture : random() < 0.5 ? {} : undefined;
      store.edit(drawnEdit(store, random), gesture);
      const { document } = store.current();
      assert.ok(sound(document), `seed ${seed}, edit ${i}`);
      assert.deepEqual(draftIn(draftText(workOf(document), 0), start), workOf(document), `seed ${seed}, edit ${i}`);
    }
    const end = store.current().document;
    while (store.current().canUndo) store.undo();
    assert.equal(store.current().document, start);
    assert.deepEqual(start, copy);
    while (store.current().canRedo) store.redo();
    assert.equal(store.current().document, end);
  }
});

/** A shelf with room for so many characters, and a clock that is moved by hand. */
function shelfOf(room = Infinity) {
  const entries = new Map();
  const size = () => [...entries].reduce((sum, [name, text]) => sum + name.length + text.length, 0);
  return {
    entries,
    writings: 0,
    get length() {
      return entries.size;
    },
    key: (i) => [...entries.keys()][i] ?? null,
    getItem: (name) => entries.get(name) ?? null,
    removeItem: (name) => void entries.delete(name),
    setItem(name, text) {
      const before = entries.get(name);
      entries.set(name, text);
      this.writings++;
      if (size() <= room) return;
      if (before === undefined) entries.delete(name);
      else entries.set(name, before);
      throw new DOMException('full', 'QuotaExceededError');
    },
  };
}

function clockOf() {
  let time = 1;
  const calls = [];
  return {
    now: () => time,
    later: (call, delay) => calls.push({ call, at: time + delay }),
    pass(delay) {
      time += delay;
      for (const due of calls.filter(({ at }) => at <= time)) {
        calls.splice(calls.indexOf(due), 1);
        due.call();
      }
    },
  };
}

const workOf = (document) => ({ document, past: [], future: [], saved: document });

const draftOf = (shelf, clock, more = {}) => {
  const told = [];
  return { told, draft: new Draft({ hash: 'abc', opened: four, shelf: () => shelf, tell: (sentence) => told.push(sentence), clock, ...more }) };
};

test('a draft is written now and then, and read back', () => {
  const [shelf, clock] = [shelfOf(), clockOf()];
  const { draft, told } = draftOf(shelf, clock);
  const store = createStore(four);
  draft.follow(store);
  for (let i = 0; i < 20; i++) turn(store, 0.01);
  assert.equal(shelf.writings, 0);
  clock.pass(1000);
  assert.equal(shelf.writings, 1);
  assert.deepEqual(draft.read(), store.work());
  turn(store, 0.1);
  draft.flush();
  assert.deepEqual(draft.read(), store.work());
  assert.deepEqual(told, []);
});

test('steps back and forth come again with the draft, and whether it is saved', () => {
  const [shelf, clock] = [shelfOf(), clockOf()];
  const { draft } = draftOf(shelf, clock);
  const store = createStore(four);
  draft.follow(store);
  const documents = [four];
  for (let i = 0; i < 50; i++) {
    turn(store, 0.01);
    documents.push(store.current().document);
    if (i === 20) store.tellSaved();
  }
  for (let i = 0; i < 7; i++) store.undo();
  draft.flush();
  const work = draft.read();
  assert.deepEqual(work, store.work());
  const again = createStore(work.document, work.saved, work);
  for (let i = 0; i < 7; i++) again.redo();
  for (const document of documents.toReversed()) {
    assert.deepEqual(again.current().document, document);
    assert.equal(again.current().isSaved, document === documents[21]);
    again.undo();
  }
  assert.equal(again.current().canUndo, false);
  assert.ok(shelf.getItem('orispline-studio:abc').length < 60 * 200, 'a step holds what it changed');
});

test('where there is no room for all steps the last ones are kept', () => {
  const store = createStore(four);
  for (let i = 0; i < 300; i++) turn(store, 0.01);
  const { draft, told } = draftOf(shelfOf(draftText(store.work(), 1, 100).length + 50), clockOf());
  draft.keep(store.work());
  draft.flush();
  assert.deepEqual(told, []);
  assert.deepEqual(draft.read().past, store.work().past.slice(-100));
  assert.deepEqual(draft.read().document, store.current().document);
});

test('what is as it was opened, without a step, needs no draft', () => {
  const [shelf, clock] = [shelfOf(), clockOf()];
  const { draft } = draftOf(shelf, clock);
  const store = createStore(four);
  draft.follow(store);
  turn(store, 0.1);
  draft.flush();
  assert.equal(shelf.length, 1);
  store.undo();
  draft.flush();
  assert.deepEqual(draft.read(), store.work()); // what was undone can be done again
  draft.keep(workOf(four));
  draft.flush();
  assert.equal(shelf.length, 0);
  turn(store, 0.1);
  draft.flush();
  draft.drop();
  assert.equal(draft.read(), null);
});

test('a draft holds free rates and the sign of 0', () => {
  const keys = keysOfAngles([0, 1], (i) => ({ q: [-0, 0, 0, 1], rates: [i ? [NaN, NaN, NaN] : [-0, 1, 2]] }));
  const document = documentOf(keys, { method: 'timed-c2', settings: { closed: true, ends: 'rest', tension: -0 } });
  assert.deepEqual(draftIn(draftText(workOf(document), 5), document), workOf(document));
});

test('a draft that is damaged or of something else is none', () => {
  const whole = JSON.parse(draftText({ ...workOf(edit.turnedInWorld(four, 2, [0, 0, 1])), past: [four] }, 7));
  assert.ok(draftIn(JSON.stringify(whole), four));
  const key = whole.keys[1];
  const damages = [
    (d) => (d.draft = 1), (d) => (d.keys = []), (d) => (d.keys = {}), (d) => d.keys.splice(0), (d) => (d.keys[1].t = 0), (d) => (d.keys[1].t = '1'), (d) => (d.keys[1].t = null),
    (d) => (d.keys[1].id = 1), (d) => (d.keys[1].id = -1), (d) => (d.keys[1].row = 0), (d) => (d.keys[3].row = 4), (d) => (d.keys[1].q = [1, 0, 0]),
    (d) => (d.keys[1].q = [2, 0, 0, 0]), (d) => (d.keys[1].q = [null, 0, 0, 1]), (d) => (d.keys[1].p = [0, 0, 0]),
    (d) => (d.keys[1].rates = [[0, 0, 0]]), (d) => (d.keys[1].own = { tension: 1 }), (d) => (d.keys[1].own = []),
    (d) => (d.choices[0] = null), (d) => (d.choices[0].method = 5), (d) => (d.choices[0].method = 'x'.repeat(101)),
    (d) => (d.choices[1].settings = { ends: {} }), (d) => (d.choices[1].settings = { ends: null }), (d) => (d.steps = null), (d) => (d.steps[0] = null),
    (d) => (d.steps[0].removed = 1), (d) => (d.steps[1].from = 9), (d) => d.steps[1].keys.push(99), (d) => (d.steps[1].first = 5), (d) => (d.steps[0].keys = []),
    (d) => (d.now = 2), (d) => (d.now = -1), (d) => (d.saved = 2), (d) => (d.saved = 'x'),
    (d) => ([d.keys, d.steps[0].keys, d.steps[1]] = [Array.from({ length: 1001 }, (_, i) => ({ ...key, id: i, row: null, t: i })), Array.from({ length: 1001 }, (_, i) => i), { ...d.steps[1], removed: 0, keys: [] }]),
  ];
  for (const damage of damages) {
    const damaged = structuredClone(whole);
    damage(damaged);
    assert.equal(draftIn(JSON.stringify(damaged), four), null, damage.toString());
  }
  for (const text of [null, '', '{', 'null', '[]', '"x"', '7']) assert.equal(draftIn(text, four), null);
});

test('the newest twenty drafts are kept, and nothing that is not a draft is touched', () => {
  const [shelf, clock] = [shelfOf(), clockOf()];
  shelf.setItem('theme', 'dark');
  const changed = edit.turnedInWorld(four, 2, [0, 0, 1]);
  for (let i = 0; i < 25; i++) {
    const { draft } = draftOf(shelf, clock, { hash: `file ${i}` });
    draft.keep(workOf(changed));
    clock.pass(1000);
  }
  assert.equal(shelf.length, 21);
  assert.equal(shelf.getItem('theme'), 'dark');
  assert.equal(shelf.getItem('orispline-studio:file 4'), null);
  assert.ok(shelf.getItem('orispline-studio:file 5'));
});

test('where the shelf is full older drafts go; where that is not enough one sentence says so, once', () => {
  const changed = edit.turnedInWorld(four, 2, [0, 0, 1]);
  const size = draftText(workOf(changed), 1).length;
  const [shelf, clock] = [shelfOf(2.5 * size), clockOf()];
  for (const hash of ['one', 'two', 'three']) {
    const { draft, told } = draftOf(shelf, clock, { hash });
    draft.keep(workOf(changed));
    clock.pass(1000);
    assert.deepEqual(told, []);
  }
  assert.equal(shelf.getItem('orispline-studio:one'), null);
  const full = shelfOf(0.5 * size);
  const { draft, told } = draftOf(full, clock);
  for (let i = 0; i < 3; i++) {
    draft.keep(workOf(changed));
    draft.flush();
  }
  assert.equal(told.length, 1);
  assert.match(told[0], /has no room left for the draft.*Save the keys/);
});

test('a browser that keeps nothing is one sentence, never an exception', () => {
  const { draft, told } = draftOf(null, clockOf(), {
    shelf: () => {
      throw new DOMException('denied', 'SecurityError');
    },
  });
  assert.equal(draft.read(), null);
  draft.keep(workOf(edit.turnedInWorld(four, 2, [0, 0, 1])));
  draft.flush();
  draft.drop();
  assert.equal(told.length, 1);
  assert.match(told[0], /keeps nothing for this page/);
});
