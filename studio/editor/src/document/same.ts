// SPDX-License-Identifier: Apache-2.0
// Whether two documents have the same content, to the last bit.
import type { Choice, Key, StudioDocument } from './document';

const sameNumbers = (some: readonly number[], others: readonly number[]): boolean =>
  some === others || (some.length === others.length && some.every((number, i) => Object.is(number, others[i])));

/** Of numbers and words, in any order of their names. */
export function sameMembers(some: Readonly<Record<string, unknown>>, others: Readonly<Record<string, unknown>>): boolean {
  const names = Object.keys(some);
  return some === others || (names.length === Object.keys(others).length && names.every((name) => name in others && Object.is(some[name], others[name])));
}

/** What a file holds of a key. */
export const sameContent = (some: Key, other: Key): boolean =>
  some === other ||
  (Object.is(some.t, other.t) &&
    sameNumbers(some.q, other.q) &&
    sameNumbers(some.p ?? [], other.p ?? []) &&
    some.rates.length === other.rates.length &&
    some.rates.every((rate, order) => sameNumbers(rate, other.rates[order])) &&
    sameMembers(some.own, other.own));

/** Of two documents with the same history: a key that was deleted and one that was made in its place are two keys. */
export const sameKey = (some: Key, other: Key): boolean => some === other || (some.id === other.id && some.row === other.row && sameContent(some, other));

export const sameChoice = (some: Choice, other: Choice): boolean => some === other || (some.method === other.method && sameMembers(some.settings, other.settings));

export const sameDocument = (some: StudioDocument, other: StudioDocument): boolean =>
  some === other ||
  (sameChoice(some.first, other.first) &&
    sameChoice(some.second, other.second) &&
    some.keys.length === other.keys.length &&
    some.keys.every((key, i) => sameKey(key, other.keys[i])));
