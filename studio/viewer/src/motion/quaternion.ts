// SPDX-License-Identifier: Apache-2.0
// Rotations: unit quaternions, body to world; rotation vectors in the body frame, full angle [rad].

export type Quaternion = [w: number, x: number, y: number, z: number];
export type Vector = [x: number, y: number, z: number];
export type Axis = 'x' | 'y' | 'z';
export type Up = 'y' | 'z'; // axis of the world

export const product = ([w, x, y, z]: Quaternion, [a, b, c, d]: Quaternion): Quaternion => [
  w * a - x * b - y * c - z * d,
  w * b + x * a + y * d - z * c,
  w * c - x * d + y * a + z * b,
  w * d + x * c - y * b + z * a,
];

export const inverse = ([w, x, y, z]: Quaternion): Quaternion => [w, -x, -y, -z];

export function exponential([x, y, z]: Vector, part = 1): Quaternion {
  const angle = Math.hypot(x, y, z);
  const scale = angle > 0 ? Math.sin((part * angle) / 2) / angle : 0;
  return [Math.cos((part * angle) / 2), scale * x, scale * y, scale * z];
}

/** Of the shorter way. */
export function logarithm([w, x, y, z]: Quaternion): Vector {
  const size = Math.hypot(x, y, z);
  const scale = size > 0 ? (2 * Math.atan2(w < 0 ? -size : size, Math.abs(w))) / size : 0;
  return [scale * x, scale * y, scale * z];
}

/** Angle of the rotation from one orientation to the other [deg], 0 to 180. */
export function angleBetween(from: Quaternion, to: Quaternion): number {
  const [w, x, y, z] = product(inverse(from), to);
  return (2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w)) * 180) / Math.PI;
}

/** Direction of a body axis in the world. */
export function bodyAxis([w, x, y, z]: Quaternion, axis: Axis): Vector {
  if (axis === 'x') return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  if (axis === 'y') return [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}
