// SPDX-License-Identifier: Apache-2.0
// Lines as wide in pixels as they are to be, broken where there are gaps.
import { Color, Group, LinearSRGBColorSpace, type GreaterDepth, type InterleavedBufferAttribute } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Colours } from '../look/theme';

export interface TrailLook {
  width: number; // pixels of the page
  strength?: number; // of its colour on the ground's: where segments meet one sees nothing, as one does through what is transparent
  order?: number; // what has more is drawn later, and over it
  depthFunc?: typeof GreaterDepth;
  fog?: boolean;
}

/** As eyes mix it, not light. */
const asShown = (colour: string) => new Color().setStyle(colour, LinearSRGBColorSpace);

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
  private readonly lines: LineSegments2[];
  private readonly strengths: number[] = [];
  private room = 0; // for segments

  constructor(...looks: TrailLook[]) {
    this.lines = looks.map(({ width, strength = 1, order = 0, ...more }) => {
      this.strengths.push(strength);
      const line = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: width, transparent: true, depthWrite: false, ...more }));
      line.renderOrder = order;
      line.frustumCulled = false;
      return line;
    });
    this.object.add(...this.lines);
    this.makeRoom(1);
    this.set(new Float32Array());
  }

  paint(colour: string, { ground }: Colours): void {
    this.lines.forEach(({ material }, i) => material.color.copy(asShown(ground).lerp(asShown(colour), this.strengths[i]).convertSRGBToLinear()));
  }

  /** x, y, z of each point. */
  set(points: Float32Array): void {
    const segments = segmentsOf(points);
    const count = segments.length / 6;
    this.object.visible = count > 0;
    if (count > this.room) this.makeRoom(Math.max(count, 2 * this.room));
    const [{ geometry }] = this.lines;
    const { data } = geometry.getAttribute('instanceStart') as InterleavedBufferAttribute;
    data.array.set(segments);
    data.needsUpdate = true;
    geometry.instanceCount = count;
  }

  private makeRoom(room: number): void {
    this.room = room;
    const [{ geometry: before }] = this.lines;
    const geometry = new LineSegmentsGeometry().setPositions(new Float32Array(6 * room));
    for (const line of this.lines) line.geometry = geometry;
    before.dispose();
  }
}
