// SPDX-License-Identifier: Apache-2.0
// Keys that come and go.
import type { Key, Quaternion, StudioDocument, Vector } from '../document/document';
import { newId, withKeys } from '../document/keys';
import { roomBetween } from './time';
import { normalised } from './turn';

/** Where the new key is among those of a document; null: there was no room, and the document is the same one. */
export interface WithNewKey {
  readonly document: StudioDocument;
  readonly id: number | null;
}

export interface Pose {
  readonly q: Quaternion;
  readonly p: Vector | null;
}

const fewest = 2; // keys that a curve goes through

const free: Vector = [NaN, NaN, NaN]; // a rate that the curve chooses

/** Between two keys linear in time; beyond the ends that of the end. */
function ownAt(before: Key | undefined, after: Key | undefined, t: number): Record<string, number> {
  const [from, to] = [before ?? after!, after ?? before!];
  const part = to.t > from.t ? (t - from.t) / (to.t - from.t) : 0;
  return Object.fromEntries(Object.entries(from.own).map(([name, value]) => [name, value === to.own[name] ? value : (1 - part) * value + part * to.own[name]]));
}

function added(document: StudioDocument, t: number, make: (before: Key | undefined, after: Key | undefined) => Omit<Key, 'id' | 'row' | 't'>): WithNewKey {
  const { keys } = document;
  const place = keys.findIndex((key) => key.t >= t);
  const index = place < 0 ? keys.length : place;
  const [before, after] = [keys[index - 1], keys[index]];
  const room = roomBetween(keys, before?.t, after?.t);
  if (!room || !(room.min <= t && t <= room.max)) return { document, id: null };
  const id = newId(document);
  return { document: withKeys(document, keys.toSpliced(index, 0, { id, row: null, t, ...make(before, after) })), id };
}

/**
 * A key at a time [s], where a curve is then. Values of its own are between those of its neighbours; rates, where keys have some, are left
 * to the curve.
 */
export function inserted(document: StudioDocument, t: number, { q, p }: Pose): WithNewKey {
  const { keys } = document;
  if (!Number.isFinite(t) || !q.every(Number.isFinite) || !q.some(Boolean) || keys.length === 0) return { document, id: null };
  const place = keys[0].p && (p ?? keys[0].p);
  if (place && !place.every(Number.isFinite)) return { document, id: null };
  return added(document, t, (before, after) => ({ q: normalised(q), p: place, rates: keys[0].rates.map(() => free), own: ownAt(before, after, t) }));
}

/** The same pose once more: in the middle to the next key, after the last one a step later. */
export function duplicated(document: StudioDocument, id: number): WithNewKey {
  const { keys } = document;
  const index = keys.findIndex((key) => key.id === id);
  if (index < 0) return { document, id: null };
  const [before, key, after] = [keys[index - 1], keys[index], keys[index + 1]];
  const { q, p, rates, own } = key;
  return added(document, after ? (key.t + after.t) / 2 : key.t + (before ? key.t - before.t : 1), () => ({ q, p, rates, own }));
}

export const canDelete = ({ keys }: StudioDocument): boolean => keys.length > fewest;

/** Without a key, unless it is one of the last two. */
export function deleted(document: StudioDocument, id: number): StudioDocument {
  const kept = document.keys.filter((key) => key.id !== id);
  return canDelete(document) && kept.length < document.keys.length ? withKeys(document, kept) : document;
}
