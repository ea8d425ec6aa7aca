// SPDX-License-Identifier: Apache-2.0
// Polylines in space with fewer points, from which no eye tells them apart.

const longestChord = 48; // points that it stands for at most

/** The square of the distance of a point from a segment. */
function offSegment(points: Float32Array, point: number, from: number, to: number): number {
  let [along, length] = [0, 0];
  for (let k = 0; k < 3; ++k) {
    const way = points[3 * to + k] - points[3 * from + k];
    along += way * (points[3 * point + k] - points[3 * from + k]);
    length += way * way;
  }
  const part = length > 0 ? Math.min(Math.max(along / length, 0), 1) : 0;
  let off = 0;
  for (let k = 0; k < 3; ++k) off += (points[3 * from + k] + part * (points[3 * to + k] - points[3 * from + k]) - points[3 * point + k]) ** 2;
  return off;
}

/** Whether a chord is near to all points between; a gap ends it. */
function isChord(points: Float32Array, from: number, to: number, tolerance: number): boolean {
  for (let point = from + 1; point <= to; ++point) if (!(offSegment(points, point, from, to) <= tolerance * tolerance)) return false;
  return true;
}

/** x, y, z of the points that are left: the others are no farther than the tolerance from their line. */
export function thinned(points: Float32Array, tolerance: number): Float32Array {
  const count = points.length / 3;
  const left: number[] = [];
  for (let from = 0; from < count; ) {
    left.push(...points.subarray(3 * from, 3 * from + 3));
    let to = from + 1;
    while (to + 1 < count && to - from < longestChord && isChord(points, from, to + 1, tolerance)) ++to;
    from = to;
  }
  return Float32Array.from(left);
}
