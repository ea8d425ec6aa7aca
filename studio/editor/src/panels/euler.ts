// SPDX-License-Identifier: Apache-2.0
// Euler angles [rad] in all 24 orders, as docs/files.md names them: capitals are turns about the body's axes, each where the turns before
// have left it, small letters turns about the world's axes. The formulas are those of src/orispline/math/euler.hpp.
import type { Quaternion, Vector } from '../document/document';
import { product } from 'orispline-viewer/motion/quaternion';

const ofThree = ['ZYX', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY'];
const ofTwo = ['XYX', 'XZX', 'YXY', 'YZY', 'ZXZ', 'ZYZ'];
export const bodyOrders = [...ofThree, ...ofTwo];
export const worldOrders = bodyOrders.map((order) => order.toLowerCase());

const lock = 16 * Number.EPSILON; // sine of half the angle to a gimbal lock up to which the first and the third angle are rounding

interface Order {
  turns: number[]; // 0 x, 1 y, 2 z
  isOfWorld: boolean;
}

const orderOf = (name: string): Order => ({ turns: [...name.toUpperCase()].map((letter) => 'XYZ'.indexOf(letter)), isOfWorld: name === name.toLowerCase() });

function turn(axis: number, angle: number): [number, number, number, number] {
  const q: [number, number, number, number] = [Math.cos(angle / 2), 0, 0, 0];
  q[axis + 1] = Math.sin(angle / 2);
  return q;
}

/** The orientation after three turns, in the order of the turns. */
export function fromEuler(name: string, angles: Vector): Quaternion {
  const { turns, isOfWorld } = orderOf(name);
  const each = turns.map((axis, i) => turn(axis, angles[i]));
  return (isOfWorld ? each.reverse() : each).reduce(product);
}

const toHalfTurn = (angle: number) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/** First and third within ±π, the second within ±π/2, or 0 to π for orders that turn twice about one axis; at gimbal lock the third is 0. */
export function toEuler(name: string, q: Quaternion): Vector {
  const { turns, isOfWorld } = orderOf(name);
  const [i, j] = [turns[isOfWorld ? 2 : 0], turns[1]];
  const k = 3 - i - j;
  const handedness = (j - i + 3) % 3 === 1 ? 1 : -1;
  const isProper = turns[0] === turns[2];
  let p = [q[0], q[i + 1], q[j + 1], handedness * q[k + 1]];
  if (!isProper) p = [p[0] - p[2], p[1] - p[3], p[2] + p[0], p[3] + p[1]].map((value) => value * Math.SQRT1_2);
  let [cosine, sine] = [Math.hypot(p[0], p[1]), Math.hypot(p[2], p[3])];
  let [sum, difference] = [Math.atan2(p[1], p[0]), Math.atan2(p[3], p[2])];
  const kept = isOfWorld ? -1 : 1; // makes the third turn, as the caller counts, the one that is 0
  if (sine <= lock) [sine, difference] = [0, kept * sum];
  if (cosine <= lock) [cosine, sum] = [0, kept * difference];
  const second = 2 * Math.atan2(sine, cosine);
  const angles: [number, number, number] = isProper
    ? [toHalfTurn(sum + difference), second, toHalfTurn(sum - difference)]
    : [toHalfTurn(sum + difference), second - Math.PI / 2, toHalfTurn(-handedness * (sum - difference))];
  return isOfWorld ? [angles[2], angles[1], angles[0]] : angles;
}
