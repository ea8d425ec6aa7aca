// SPDX-License-Identifier: Apache-2.0
// Rotations: unit quaternions, body to world; rotation vectors in the body frame, full angle [rad].

export type Quaternion = [w: number, x: number, y: number, z: number];
export type Vector = [x: number, y: number, z: number];
export type Axis = 'x' | 'y' | 'z';

// For every point of a curve there are quaternions in typed arrays. Lists of numbers would take several times as long: where V8 meets one
// in code that has seen a list of something else, it makes it such a list, and then all that come from the same place.
export type Place = Float64Array;

export const four = (numbers: ArrayLike<number> = [1, 0, 0, 0]): Place => Float64Array.of(numbers[0], numbers[1], numbers[2], numbers[3]);

export const quaternionIn = (place: Place): Quaternion => [place[0], place[1], place[2], place[3]];

/** Either of both may lie where their product goes. */
export function multiply(into: Place, p: Place, q: Place): void {
  const w = p[0], x = p[1], y = p[2], z = p[3], a = q[0], b = q[1], c = q[2], d = q[3];
  into[0] = w * a - x * b - y * c - z * d;
  into[1] = w * b + x * a + y * d - z * c;
  into[2] = w * c - x * d + y * a + z * b;
  into[3] = w * d + x * c - y * b + z * a;
}

const [left, right] = [four(), four()];

export function product(p: Quaternion, q: Quaternion): Quaternion {
  left.set(p);
  right.set(q);
  multiply(left, left, right);
  return quaternionIn(left);
}

export const inverse = ([w, x, y, z]: Quaternion): Quaternion => [w, -x, -y, -z];

/** Those of parts of a rotation vector. */
export function exponentialsOf([x, y, z]: Vector): (into: Place, part: number) => void {
  const angle = Math.hypot(x, y, z);
  return (into, part) => {
    const scale = angle > 0 ? Math.sin((part * angle) / 2) / angle : 0;
    into[0] = Math.cos((part * angle) / 2);
    into[1] = scale * x;
    into[2] = scale * y;
    into[3] = scale * z;
  };
}

export function exponential(turn: Vector): Quaternion {
  exponentialsOf(turn)(left, 1);
  return quaternionIn(left);
}

/** Of the shorter way. */
export function logarithm([w, x, y, z]: Quaternion): Vector {
  const size = Math.hypot(x, y, z);
  const scale = size > 0 ? (2 * Math.atan2(w < 0 ? -size : size, Math.abs(w))) / size : 0;
  return [scale * x, scale * y, scale * z];
}

/** Angle of the rotation from one orientation to the other [deg], 0 to 180. */
export function angleOf(from: Place, to: Place): number {
  left[0] = from[0];
  left[1] = -from[1];
  left[2] = -from[2];
  left[3] = -from[3];
  multiply(left, left, to);
  return (2 * Math.atan2(Math.hypot(left[1], left[2], left[3]), Math.abs(left[0])) * 180) / Math.PI;
}

export const angleBetween = (from: Quaternion, to: Quaternion): number => angleOf(four(from), four(to));

/** Direction of a body axis in the world. */
export function axisOf(q: Place, axis: Axis): Vector {
  const w = q[0], x = q[1], y = q[2], z = q[3];
  if (axis === 'x') return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  if (axis === 'y') return [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}

export const bodyAxis = (q: Quaternion, axis: Axis): Vector => {
  const [x, y, z] = axisOf(four(q), axis);
  return [x, y, z];
};
