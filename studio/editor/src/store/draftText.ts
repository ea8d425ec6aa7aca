// SPDX-License-Identifier: Apache-2.0
// A draft as text. What is read may be anything: it is taken only where it could have been written here for the same file.
import type { Choice, Key, Quaternion, Setting, StudioDocument, Vector } from '../document/document';
import { mostKeys } from '../engine/protocol';

const version = 1;
const longestWord = 100;
const normError = 1e-6; // as the library has it for unit quaternions

// JSON has neither NaN, which leaves a rate free, nor the sign of 0.
const written = (_: string, value: unknown): unknown => (Number.isNaN(value) ? 'nan' : Object.is(value, -0) ? '-0' : value);

export const draftText = (document: StudioDocument, time: number): string => JSON.stringify({ draft: version, time, document }, written);

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

function checkKeys(keys: Key[], opened: StudioDocument): void {
  demand(1 <= keys.length && keys.length <= mostKeys);
  demand(increases(keys.map(({ t }) => t)) && new Set(keys.map(({ id }) => id)).size === keys.length);
  const rows = keys.flatMap(({ row }) => row ?? []);
  demand(increases(rows) && rows.every((row) => row < opened.keys.length));
  const names = Object.keys(keys[0].own).sort().join();
  for (const { p, rates, own } of keys) {
    demand((p === null) === (opened.keys[0].p === null) && rates.length === opened.keys[0].rates.length);
    demand(Object.keys(own).sort().join() === names);
  }
}

/** The document of a draft of what was opened; null where it is damaged. */
export function draftIn(text: string | null, opened: StudioDocument): StudioDocument | null {
  if (text === null) return null;
  try {
    const { draft, document } = membersOf(JSON.parse(text));
    const { version: edition, keys: list, first, second } = membersOf(document);
    demand(draft === version && edition === opened.version);
    const keys = listOf(list, keyOf);
    checkKeys(keys, opened);
    return { version: opened.version, keys, first: choiceOf(first), second: choiceOf(second) };
  } catch {
    return null;
  }
}
