// SPDX-License-Identifier: Apache-2.0
// Where a key is in the world [m].
import type { StudioDocument, Vector } from '../document/document';
import { withKey } from '../document/keys';

const farthest = 1e18; // [m], as the library has it

/** One of its three numbers, or the nearest one that is allowed. Without positions, or where it is no number, nothing is moved. */
export function placed(document: StudioDocument, id: number, component: 0 | 1 | 2, value: number): StudioDocument {
  if (Number.isNaN(value)) return document;
  const allowed = Math.min(Math.max(value, -farthest), farthest);
  return withKey(document, id, (key) => (!key.p || key.p[component] === allowed ? key : { ...key, p: [...key.p].with(component, allowed) as unknown as Vector }));
}
