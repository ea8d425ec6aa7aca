// SPDX-License-Identifier: Apache-2.0
// From where points around the origin are seen best, and from how far.
import { Quaternion, Vector3, type PerspectiveCamera } from 'three';
import type { Up } from '../motion/quaternion';

const elevation = 0.42; // [rad]
const azimuths = 48;
const first = -0.6; // [rad] Of several that are as good: an axis does not point to the eye

/** Turns a world of z up into one where another axis is. */
export const standing: Record<Up, Quaternion> = { z: new Quaternion(), y: new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2) };

export const vertical = (up: Up): Vector3 => new Vector3(0, 0, 1).applyQuaternion(standing[up]);

/** What is to be seen. */
export interface View {
  eye: Vector3; // a unit vector
  points: Vector3[]; // that are to be in the picture
  share?: { width: number; height: number }; // of the picture, that they take at most
}

const whole = { width: 0.89, height: 0.89 };

interface Screen {
  right: Vector3;
  up: Vector3;
}

function screenOf(eye: Vector3, above = new Vector3(0, 0, 1)): Screen {
  const right = above.clone().cross(eye).normalize();
  return { right, up: eye.clone().cross(right) };
}

/** How far points are spread over the picture. */
function areaFrom(eye: Vector3, points: Vector3[]): number {
  const { right, up } = screenOf(eye);
  let [xx, xy, yy] = [0, 0, 0];
  for (const point of points) {
    const [x, y] = [point.dot(right), point.dot(up)];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  return xx * yy - xy * xy;
}

/** The unit vector from where most is seen. */
function bestEye(seenFrom: (eye: Vector3) => number): Vector3 {
  const eyes = Array.from({ length: azimuths }, (_, k) => {
    const azimuth = first + (2 * Math.PI * k) / azimuths;
    const eye = new Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
    return { eye, seen: seenFrom(eye) };
  });
  return eyes.reduce((a, b) => (b.seen > a.seen + 1e-6 * Math.abs(a.seen) ? b : a)).eye;
}

/** From where points are spread over the picture. */
export const eyeAcross = (points: Vector3[]): Vector3 => bestEye((eye) => areaFrom(eye, points));

const plain = 0.5; // cosine: what is turned to the eye so far is seen well

/** From where points of the unit sphere are on its front half. */
export const eyeBefore = (points: Vector3[]): Vector3 =>
  bestEye((eye) => points.reduce((sum, point) => sum + Math.min(Math.max(point.dot(eye), -0.2), plain), 0));

/** Place of the camera, which looks at the origin. */
export function placeOf({ eye, points, share = whole }: View, { fov, aspect, up: above }: PerspectiveCamera): Vector3 {
  const { right, up } = screenOf(eye, above);
  const slope = Math.tan((fov * Math.PI) / 360);
  const [across, high] = [slope * aspect * share.width, slope * share.height];
  const distance = points.reduce((most, point) => Math.max(most, point.dot(eye) + Math.max(Math.abs(point.dot(right)) / across, Math.abs(point.dot(up)) / high)), 0);
  return eye.clone().multiplyScalar(distance);
}

/** From any side it looks as large as a ball. */
export const ball = (radius: number): Vector3[] =>
  Array.from({ length: 96 }, (_, k) => {
    const z = 1 - (2 * k + 1) / 96; // Fibonacci's spiral
    const azimuth = Math.PI * (1 + Math.sqrt(5)) * k;
    return new Vector3(Math.sqrt(1 - z * z) * Math.cos(azimuth), Math.sqrt(1 - z * z) * Math.sin(azimuth), z).multiplyScalar(radius);
  });
