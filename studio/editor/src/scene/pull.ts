// SPDX-License-Identifier: Apache-2.0
// What a pull at a scene means.
import { Vector3, type Ray } from 'three';
import type { Vector } from 'orispline-viewer/motion/quaternion';

/** The direction in which a ray from the eye meets a ball around the origin, before it or behind; beyond its edge, the nearest of its outline. */
export function directionUnder({ origin, direction }: Ray, radius: number, isBehind: boolean): Vector3 {
  const eye = origin.clone().divideScalar(radius);
  const along = eye.dot(direction);
  const room = along * along - eye.lengthSq() + 1;
  if (room >= 0) return eye.addScaledVector(direction, isBehind ? -along + Math.sqrt(room) : -along - Math.sqrt(room)).normalize();
  const distance = eye.length();
  const sight = eye.divideScalar(distance);
  const aside = direction.clone().addScaledVector(sight, -direction.dot(sight)).normalize();
  return sight.divideScalar(distance).addScaledVector(aside, Math.sqrt(1 - 1 / (distance * distance)));
}

/** The rotation vector of the smallest turn from one direction to another [rad]. */
export function turnBetween(from: Vector3, to: Vector3): Vector {
  const across = new Vector3().crossVectors(from, to);
  const sine = across.length();
  const angle = Math.atan2(sine, from.dot(to));
  if (sine > 0) return across.multiplyScalar(angle / sine).toArray();
  const aside = Math.abs(from.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0); // half a turn about any axis across
  return across.crossVectors(from, aside).normalize().multiplyScalar(angle).toArray();
}

export interface Ring {
  middle: Vector3;
  axis: Vector3; // a unit vector
  radius: number;
}

const plain = 0.5; // cosine: a ring that is turned to the eye so far is pulled around, others along

const onPlane = ({ origin, direction }: Ray, { middle }: Ring, normal: Vector3) =>
  origin.clone().addScaledVector(direction, middle.clone().sub(origin).dot(normal) / direction.dot(normal)).sub(middle);

/** How far a ring is turned so that it follows the pointer from one ray to another [rad], within half a turn. */
export function turnOfRing(ring: Ring, from: Ray, to: Ray): number {
  const { middle, axis, radius } = ring;
  const sight = from.origin.clone().sub(middle).normalize();
  if (Math.abs(axis.dot(sight)) > plain) {
    const [a, b] = [onPlane(from, ring, axis), onPlane(to, ring, axis)];
    return Math.atan2(new Vector3().crossVectors(a, b).dot(axis), a.dot(b));
  }
  const along = new Vector3().crossVectors(axis, sight).normalize();
  return onPlane(to, ring, sight).sub(onPlane(from, ring, sight)).dot(along) / radius;
}
