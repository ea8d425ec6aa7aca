// SPDX-License-Identifier: Apache-2.0
// From where points around the origin are seen best.
import { Vector3, type PerspectiveCamera } from 'three';

const elevation = 0.45; // [rad]
const azimuths = 48;
const margin = 1.12;

interface Picture {
  eye: Vector3; // unit vector
  area: number; // how far the points are spread
  distance: number; // from which all of them are in the picture
}

function pictureFrom(eye: Vector3, points: Vector3[], { fov, aspect }: PerspectiveCamera): Picture {
  const right = new Vector3(0, 0, 1).cross(eye).normalize();
  const up = eye.clone().cross(right);
  const slope = Math.tan((fov * Math.PI) / 360) / margin;
  let [xx, xy, yy, distance] = [0, 0, 0, 0];
  for (const point of points) {
    const [x, y, depth] = [point.dot(right), point.dot(up), point.dot(eye)];
    const weight = depth > -0.2 ? 1 : 0.3; // what is behind is hidden, or small
    xx += weight * x * x;
    xy += weight * x * y;
    yy += weight * y * y;
    distance = Math.max(distance, depth + Math.max(Math.abs(y), Math.abs(x) / aspect) / slope);
  }
  return { eye, area: xx * yy - xy * xy, distance };
}

/** Place of the camera, which looks at the origin, z up. */
export function viewOf(points: Vector3[], camera: PerspectiveCamera): Vector3 {
  const pictures = Array.from({ length: azimuths }, (_, k) => {
    const azimuth = (2 * Math.PI * k) / azimuths;
    const eye = new Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
    return pictureFrom(eye, points, camera);
  });
  const best = pictures.reduce((a, b) => (b.area > a.area * (1 + 1e-6) ? b : a));
  return best.eye.multiplyScalar(best.distance);
}

/** The same from one side. */
export function viewFrom(eye: Vector3, points: Vector3[], camera: PerspectiveCamera): Vector3 {
  return eye.clone().multiplyScalar(pictureFrom(eye, points, camera).distance);
}
