// SPDX-License-Identifier: Apache-2.0
// The orientation of a key. What is not finite, or has no direction, turns nothing: the same document comes back. Rates, which are in
// the body frame, stay.
import { exponential, product } from 'orispline-viewer/motion/quaternion';
import type { Quaternion, StudioDocument, Vector } from '../document/document';
import { alignment, areAligned, opposite, withKey, withKeys } from '../document/keys';

/** Norm without overflow; the bits are those of the library, so that it finds nothing left to divide. */
function normOf(q: Quaternion): number {
  const largest = Math.max(...q.map(Math.abs));
  const [w, x, y, z] = q.map((number) => number * (1 / largest));
  return largest > 0 ? largest * Math.sqrt(x * x + z * z + (y * y + w * w)) : 0;
}

/** Of norm 1, as near as doubles come: divided until that brings it no nearer. */
export function normalised(q: Quaternion): Quaternion {
  const norm = normOf(q);
  const divided = q.map((number) => number / norm) as unknown as Quaternion;
  return Math.abs(normOf(divided) - 1) < Math.abs(norm - 1) ? normalised(divided) : q;
}

/** Of the two signs that which is nearer to the key before; the first key, and one of signs that are not aligned, keeps to its own. */
function turned(document: StudioDocument, id: number, turn: (q: Quaternion) => Quaternion): StudioDocument {
  const { keys } = document;
  const isAligned = areAligned(keys);
  const next = withKey(document, id, (key, index) => {
    const q = turn(key.q);
    if (!q.every(Number.isFinite) || !(normOf(q) > 0)) return key;
    const unit = normalised(q);
    const signed = alignment((isAligned ? keys[index - 1] : key)?.q ?? key.q, unit) < 0 ? opposite(unit) : unit;
    return signed.every((number, i) => number === key.q[i]) ? key : { ...key, q: signed };
  });
  return next === document ? document : withKeys(document, next.keys);
}

/** To an orientation of any norm but 0. */
export const turnedTo = (document: StudioDocument, id: number, q: Quaternion): StudioDocument => turned(document, id, () => q);

/** By a rotation vector [rad] in the world frame. */
export const turnedInWorld = (document: StudioDocument, id: number, by: Vector): StudioDocument =>
  turned(document, id, (q) => product(exponential([...by]), [...q]));

/** By a rotation vector [rad] in the body frame. */
export const turnedInBody = (document: StudioDocument, id: number, by: Vector): StudioDocument =>
  turned(document, id, (q) => product([...q], exponential([...by])));
