// SPDX-License-Identifier: Apache-2.0
// Why what was typed cannot be: a sentence that says what was found, what was wanted, and the cure; null where it can be.
import type { StudioDocument } from '../document/document';
import { canDelete } from './keys';
import { timesFor } from './time';

const decimal = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** A decimal number, as files have them; null where it is none, or none that is finite. A minus sign may be the typographer's. */
export function numberIn(text: string): number | null {
  const plain = text.trim().replace('\u2212', '-');
  const number = decimal.test(plain) ? Number(plain) : NaN;
  return Number.isFinite(number) ? number : null;
}

export const notANumber = (text: string): string | null =>
  numberIn(text) === null ? `Found “${text.trim()}”, wanted a number such as -12.5. Type digits with a point.` : null;

export function notATime(document: StudioDocument, id: number, t: number): string | null {
  const { min, max } = timesFor(document, id);
  if (min <= t && t <= max) return null;
  return `Found the time ${t} s, wanted one between its neighbours, ${min} to ${max} s. Move the neighbour first, or delete it.`;
}

export const notAValue = ({ name, min, max }: { name: string; min: number; max: number }, value: number): string | null =>
  min <= value && value <= max ? null : `Found ${value} for ${name}, wanted ${min} to ${max}. Type a number in this range.`;

export const notAQuaternion = (q: readonly number[]): string | null =>
  q.every(Number.isFinite) && q.some(Boolean) ? null : 'Found a quaternion without a direction, wanted four numbers that are not all 0. Type one that is not.';

export const notDeleted = (document: StudioDocument): string | null =>
  canDelete(document) ? null : 'Found two keys, wanted more before one is deleted: a curve goes through two keys at least. Insert another one first.';
