// SPDX-License-Identifier: Apache-2.0
// Keys of a document, one of them made anew.
import type { Key, Quaternion, StudioDocument } from './document';

/** The document with one key in the place of another; the same one where there is no such key, or where it stays. */
export function withKey(document: StudioDocument, id: number, change: (key: Key, index: number) => Key): StudioDocument {
  const index = document.keys.findIndex((key) => key.id === id);
  if (index < 0) return document;
  const changed = change(document.keys[index], index);
  return changed === document.keys[index] ? document : { ...document, keys: document.keys.with(index, changed) };
}

export const alignment = ([a, b, c, d]: Quaternion, [w, x, y, z]: Quaternion): number => a * w + b * x + c * y + d * z;

export const opposite = ([w, x, y, z]: Quaternion): Quaternion => [-w, -x, -y, -z];

/** Whether each key has that of its two signs which is nearer to the key before. */
export const areAligned = (keys: readonly Key[]): boolean => keys.every((key, i) => i === 0 || alignment(keys[i - 1].q, key.q) >= 0);

function aligned(keys: readonly Key[]): readonly Key[] {
  const signed: Key[] = [];
  for (const key of keys) {
    const before = signed.at(-1);
    signed.push(before && alignment(before.q, key.q) < 0 ? { ...key, q: opposite(key.q) } : key);
  }
  return signed;
}

/** The document with other keys. Signs that were aligned still are; where a file says by them which way round to turn they stay. */
export const withKeys = (document: StudioDocument, keys: readonly Key[]): StudioDocument => ({ ...document, keys: areAligned(document.keys) ? aligned(keys) : keys });

let lastId = 0;

/** An id that no key has had since the page was opened, not even one that was deleted. */
export function newId({ keys }: StudioDocument): number {
  for (const { id } of keys) lastId = Math.max(lastId, id);
  return ++lastId;
}
