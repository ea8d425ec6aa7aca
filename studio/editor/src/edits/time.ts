// SPDX-License-Identifier: Apache-2.0
// When a key is. It never passes a neighbour, nor comes so near to one that curves suffer.
import type { Key, StudioDocument } from '../document/document';
import { withKey } from '../document/keys';

export interface Range {
  readonly min: number; // [s]
  readonly max: number;
}

const nearest = 1e-6; // of the time between the two neighbours
const nearestOfAll = 1e-9; // of the time from the first key to the last: the library compares steps that are seen together
const farthest = 1e6; // of that time, beyond the ends

const span = (keys: readonly Key[]): number => (keys.length > 1 ? keys[keys.length - 1].t - keys[0].t : 1);

/** Where a key may be between two times; null where there is no room. An end that is not there is far away. */
export function roomBetween(keys: readonly Key[], before: number | undefined, after: number | undefined): Range | null {
  const all = span(keys);
  const open = before === undefined || after === undefined;
  const size = Math.max(Math.abs(before ?? 0), Math.abs(after ?? 0));
  const margin = Math.max(open ? 0 : nearest * (after - before), nearestOfAll * all, 8 * Number.EPSILON * size);
  const min = before === undefined ? (after ?? 0) - farthest * all : before + margin;
  const max = after === undefined ? (before ?? 0) + farthest * all : after - margin;
  return min < max ? { min, max } : null;
}

/** Where a key may be moved to; where it is now is always among that. */
export function timesFor({ keys }: StudioDocument, id: number): Range {
  const index = keys.findIndex((key) => key.id === id);
  if (index < 0) return { min: 0, max: 0 };
  const { t } = keys[index];
  const room = roomBetween(keys, keys[index - 1]?.t, keys[index + 1]?.t) ?? { min: t, max: t };
  return { min: Math.min(room.min, t), max: Math.max(room.max, t) };
}

/** To a time [s], or the nearest one that is allowed. A time that is no number moves nothing. */
export function movedInTime(document: StudioDocument, id: number, t: number): StudioDocument {
  if (Number.isNaN(t)) return document;
  const { min, max } = timesFor(document, id);
  const allowed = Math.min(Math.max(t, min), max);
  return withKey(document, id, (key) => (key.t === allowed ? key : { ...key, t: allowed }));
}

const share = 0.15; // of the mean interval: where keys are nearer, smooth curves may turn more than twice as far as the keys
const room = 1 / 3; // of the time between both neighbours, where keys are dense

/** Where a drag leaves a key: off its neighbours by so much time [s] that both are seen, and by what a smooth curve needs. One that is nearer may stay. */
export function timesForDrag(document: StudioDocument, id: number, seen: number): Range {
  const { keys } = document;
  const index = keys.findIndex((key) => key.id === id);
  if (index < 0) return { min: 0, max: 0 };
  const [before, { t }, after] = [keys[index - 1], keys[index], keys[index + 1]];
  const free = before && after ? room * (after.t - before.t) : Infinity;
  const off = Math.min(Math.max(seen, (share * span(keys)) / Math.max(keys.length - 1, 1)), free);
  const { min, max } = timesFor(document, id);
  return { min: before ? Math.max(min, Math.min(before.t + off, t)) : min, max: after ? Math.min(max, Math.max(after.t - off, t)) : max };
}
