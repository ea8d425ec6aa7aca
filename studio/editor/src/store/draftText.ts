// SPDX-License-Identifier: Apache-2.0
// A draft as text. What is read may be anything: it is taken only where it could have been written here for the same file.
import type { Choice, Key, Quaternion, Setting, StudioDocument, Vector } from '../document/document';
import { sameDocument } from '../document/same';
import { mostKeys } from '../engine/protocol';
import type { Work } from './store';

const version = 2;
const longestWord = 100;
const normError = 1e-6; // as the library has it for unit quaternions

// JSON has neither NaN, which leaves a rate free, nor the sign of 0.
const written = (_: string, value: unknown): unknown => (Number.isNaN(value) ? 'nan' : Object.is(value, -0) ? '-0' : value);

/** A document beside the one before it: of its list of keys the stretch that is another one. */
interface Step {
  from: number;
  removed: number;
  keys: number[]; // places of the keys that stand there now
  first: number; // places of choices
  second: number;
}

/** Values that are kept once each, wherever they stand. */
class Pool<Value> {
  readonly values: Value[] = [];
  private readonly places = new Map<Value, number>();

  placeOf(value: Value): number {
    const place = this.places.get(value);
    if (place !== undefined) return place;
    this.places.set(value, this.values.length);
    return this.values.push(value) - 1;
  }
}

function stepOf(before: readonly Key[], { keys, first, second }: StudioDocument, pool: Pool<Key>, choices: Pool<Choice>): Step {
  const most = Math.min(before.length, keys.length);
  let [from, behind] = [0, 0];
  while (from < most && before[from] === keys[from]) from++;
  while (behind < most - from && before.at(-1 - behind) === keys.at(-1 - behind)) behind++;
  const changed = keys.slice(from, keys.length - behind);
  return { from, removed: before.length - behind - from, keys: changed.map((key) => pool.placeOf(key)), first: choices.placeOf(first), second: choices.placeOf(second) };
}

/** With the steps before it and those that were undone, each of which holds what it changed. `most`: of the steps before it. */
export function draftText({ document, past, future, saved }: Work, time: number, most = Infinity): string {
  const kept = most < past.length ? past.slice(past.length - most) : past;
  const all = [...kept, document, ...future.toReversed()], [keys, choices] = [new Pool<Key>(), new Pool<Choice>()];
  const steps = all.map((one, i) => stepOf(i > 0 ? all[i - 1].keys : [], one, keys, choices));
  const place = saved ? all.findIndex((one) => sameDocument(one, saved)) : -1;
  return JSON.stringify({ draft: version, time, now: kept.length, saved: place, keys: keys.values, choices: choices.values, steps }, written);
}

/** When a draft was written [ms]; 0 of what is none. */
export function timeOf(text: string | null): number {
  const found = /^\{"draft":\d+,"time":(\d+)/.exec(text ?? '');
  return found ? Number(found[1]) : 0;
}

class Damaged extends Error {}

function demand(condition: boolean): asserts condition {
  if (!condition) throw new Damaged();
}

type Members = Record<string, unknown>;

function membersOf(value: unknown): Members {
  demand(typeof value === 'object' && value !== null && !Array.isArray(value));
  return value as Members;
}

function listOf<Item>(value: unknown, item: (value: unknown) => Item, size?: number): Item[] {
  demand(Array.isArray(value) && (size === undefined || value.length === size));
  return value.map(item);
}

function finite(value: unknown): number {
  const number = value === '-0' ? -0 : value;
  demand(typeof number === 'number' && Number.isFinite(number));
  return number;
}

const wordOf = (value: unknown): string => {
  demand(typeof value === 'string' && value.length <= longestWord);
  return value;
};

const vector = (value: unknown): Vector => listOf(value, finite, 3) as unknown as Vector;

const rate = (value: unknown): Vector =>
  Array.isArray(value) && value.length === 3 && value.every((number) => number === 'nan') ? [NaN, NaN, NaN] : vector(value);

function quaternion(value: unknown): Quaternion {
  const q = listOf(value, finite, 4);
  demand(Math.abs(Math.hypot(...q) - 1) <= normError);
  return q as unknown as Quaternion;
}

const whole = (value: unknown): number => {
  demand(Number.isSafeInteger(value) && (value as number) >= 0);
  return value as number;
};

const named = <Value>(value: unknown, member: (value: unknown) => Value): Record<string, Value> =>
  Object.fromEntries(Object.entries(membersOf(value)).map(([name, content]) => [wordOf(name), member(content)]));

function keyOf(value: unknown): Key {
  const { id, row, t, q, p, rates, own } = membersOf(value);
  return {
    id: whole(id),
    row: row === null ? null : whole(row),
    t: finite(t),
    q: quaternion(q),
    p: p === null ? null : vector(p),
    rates: listOf(rates, rate),
    own: named(own, finite),
  };
}

const setting = (value: unknown): Setting => (typeof value === 'boolean' ? value : typeof value === 'string' && value !== '-0' ? wordOf(value) : finite(value));

function choiceOf(value: unknown): Choice {
  const { method, settings } = membersOf(value);
  return { method: wordOf(method), settings: named(settings, setting) };
}

const increases = (numbers: number[]): boolean => numbers.every((number, i) => i === 0 || numbers[i - 1] < number);

/** `opened`: whose rows, positions and rates these have; null: of what was opened itself. */
function checkKeys(keys: readonly Key[], opened: StudioDocument | null): void {
  demand(1 <= keys.length && keys.length <= mostKeys);
  demand(increases(keys.map(({ t }) => t)) && new Set(keys.map(({ id }) => id)).size === keys.length);
  const rows = keys.flatMap(({ row }) => row ?? []), [like] = opened?.keys ?? keys;
  demand(increases(rows) && rows.every((row) => row < (opened ?? { keys }).keys.length));
  const names = Object.keys(keys[0].own).sort().join();
  for (const { p, rates, own } of keys) {
    demand((p === null) === (like.p === null) && rates.length === like.rates.length);
    demand(Object.keys(own).sort().join() === names);
  }
}

const placeIn = <Value>(values: readonly Value[]) => (value: unknown): Value => {
  const place = whole(value);
  demand(place < values.length);
  return values[place];
};

function documentsOf(list: unknown, keys: readonly Key[], choices: readonly Choice[], opened: StudioDocument | null): StudioDocument[] {
  let before: readonly Key[] = [];
  return listOf(list, (value) => {
    const step = membersOf(value), [from, removed] = [whole(step.from), whole(step.removed)];
    demand(from + removed <= before.length);
    const now = before.toSpliced(from, removed, ...listOf(step.keys, placeIn(keys)));
    checkKeys(now, opened);
    before = now;
    return { version: 1, keys: now, first: placeIn(choices)(step.first), second: placeIn(choices)(step.second) };
  });
}

/** The work of a draft on what was opened, null where that is in it; null where it is damaged. */
export function draftIn(text: string | null, opened: StudioDocument | null): Work | null {
  if (text === null) return null;
  try {
    const draft = membersOf(JSON.parse(text));
    demand(draft.draft === version);
    const documents = documentsOf(draft.steps, listOf(draft.keys, keyOf), listOf(draft.choices, choiceOf), opened);
    const now = whole(draft.now), saved = draft.saved === -1 ? null : whole(draft.saved);
    demand(now < documents.length && (saved === null || saved < documents.length));
    return { document: documents[now], past: documents.slice(0, now), future: documents.slice(now + 1).toReversed(), saved: saved === null ? null : documents[saved] };
  } catch {
    return null;
  }
}
