// SPDX-License-Identifier: Apache-2.0
// An orientation in words.
import type { Moments } from 'orispline-viewer/look/moments';
import { stepped } from 'orispline-viewer/look/number';
import type { Quaternion } from '../document/document';
import type { State } from '../store/store';

const degree = Math.PI / 180;

/** Angles about z, then the new y, then the new x [deg]. */
export function anglesOf([w, x, y, z]: Quaternion): [yaw: number, pitch: number, roll: number] {
  const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  const pitch = Math.asin(Math.min(Math.max(2 * (w * y - x * z), -1), 1));
  const roll = Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
  return [yaw / degree, pitch / degree, roll / degree];
}

/** The chosen key and how it is turned; nothing where none is chosen. */
export function keyWords({ document: { keys }, chosen }: Pick<State, 'document' | 'chosen'>, moments: Moments): string | null {
  const index = keys.findIndex(({ id }) => id === chosen);
  if (index < 0) return null;
  const [yaw, pitch, roll] = anglesOf(keys[index].q).map((angle) => `${stepped(angle, 0.1, 0.05)}°`);
  return `Key ${index + 1} of ${keys.length} at ${moments.text(keys[index].t)}: yaw ${yaw}, pitch ${pitch}, roll ${roll}`;
}
