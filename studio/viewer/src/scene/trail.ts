// SPDX-License-Identifier: Apache-2.0
// Lines as wide in pixels as they are to be, broken where there are gaps.
import { Group, type GreaterDepth } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

export interface TrailLook {
  width: number; // pixels of the page
  opacity?: number;
  order?: number; // what has more is drawn later, and over it
  depthFunc?: typeof GreaterDepth;
  fog?: boolean;
}

/** Ends of segments: NaN in a point is a gap. */
function segmentsOf(points: Float32Array): Float32Array {
  const segments = new Float32Array(Math.max(2 * points.length - 6, 0));
  let length = 0;
  for (let i = 0; i + 5 < points.length; i += 3) {
    const ends = points.subarray(i, i + 6);
    if (ends.some(Number.isNaN)) continue;
    segments.set(ends, length);
    length += 6;
  }
  return segments.subarray(0, length);
}

/** One line, drawn once in each of its looks. */
export class Trail {
  readonly object = new Group();
  readonly lines: LineSegments2[];

  constructor(...looks: TrailLook[]) {
    this.lines = looks.map(({ width, opacity = 1, order = 0, ...more }) => {
      const line = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: width, opacity, transparent: true, depthWrite: false, ...more }));
      line.renderOrder = order;
      return line;
    });
    this.object.add(...this.lines);
    this.object.visible = false;
  }

  paint(colour: string): void {
    for (const { material } of this.lines) material.color.set(colour);
  }

  /** x, y, z of each point. */
  set(points: Float32Array): void {
    const segments = segmentsOf(points);
    this.object.visible = segments.length > 0;
    if (!this.object.visible) return;
    this.lines[0].geometry.dispose();
    const geometry = new LineSegmentsGeometry().setPositions(segments);
    for (const line of this.lines) line.geometry = geometry;
  }
}
