// SPDX-License-Identifier: Apache-2.0
// Lines as wide in pixels as they are to be, broken where there are gaps.
import { BufferGeometry, Color, Group, InterleavedBuffer, InterleavedBufferAttribute, LinearSRGBColorSpace, Mesh, Vector4, type BufferAttribute, type GreaterDepth, type WebGLProgramParametersWithUniforms, type WebGLRenderer } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Colours } from '../look/theme';
import { repeat } from './repeated';

export interface TrailLook {
  width: number; // pixels of the page
  strength?: number; // of its colour on the ground's: where segments meet one sees nothing, as one does through what is transparent
  order?: number; // what has more is drawn later, and over it
  depthFunc?: typeof GreaterDepth;
  fog?: boolean; // that the line thins out in
}

/** As eyes mix it, not light. */
const asShown = (colour: string) => new Color().setStyle(colour, LinearSRGBColorSpace);

const segment = new LineSegmentsGeometry(); // the corners of one, which its material moves to where they are to be
const corners = segment.getAttribute('position').count;

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

const smooth = 0.985; // cosine of a bend at which no gap is seen

/** Whether a segment goes on where the one before it ended, with hardly a bend. */
function goesOn(segments: Float32Array, i: number): boolean {
  if (i === 0 || 6 * i >= segments.length) return false;
  const [from, at, to] = [6 * i - 6, 6 * i, 6 * i + 3];
  let [along, before, after] = [0, 0, 0];
  for (let k = 0; k < 3; ++k) {
    if (segments[from + 3 + k] !== segments[at + k]) return false;
    const [one, next] = [segments[at + k] - segments[from + k], segments[to + k] - segments[at + k]];
    along += one * next;
    before += one * one;
    after += next * next;
  }
  return along > smooth * Math.sqrt(before * after);
}

/** In the fog's colour alone, a line would veil what is behind it. */
function thinOut(shader: WebGLProgramParametersWithUniforms): void {
  shader.vertexShader = shader.vertexShader
    .replace('void main', '#ifdef USE_FOG\nuniform float fogNear, fogFar;\n#endif\nvoid main')
    .replace('offset *= linewidth;', '$&\n#ifdef USE_FOG\noffset *= 1.0 - smoothstep(fogNear, fogFar, -(position.y < 0.5 ? start : end).z);\n#endif');
}

const viewport = new Vector4();

function lineOf({ width, strength, order = 0, ...more }: TrailLook): Mesh<BufferGeometry, LineMaterial> {
  const material = new LineMaterial({ linewidth: width, transparent: true, depthWrite: false, ...more });
  if (more.fog) material.onBeforeCompile = thinOut;
  const line = new Mesh<BufferGeometry, LineMaterial>(undefined, material);
  line.onBeforeRender = (renderer) => {
    const { z, w } = (renderer as WebGLRenderer).getViewport(viewport);
    material.resolution.set(z, w);
  };
  line.renderOrder = order;
  line.frustumCulled = false;
  return line;
}

/** One line, drawn once in each of its looks. */
export class Trail {
  readonly object = new Group();
  private readonly lines: Mesh<BufferGeometry, LineMaterial>[];
  private readonly strengths: number[];
  private room = 0; // for segments

  constructor(...looks: TrailLook[]) {
    this.strengths = looks.map(({ strength = 1 }) => strength);
    this.lines = looks.map(lineOf);
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
    for (let i = 0; i < corners * segments.length; ++i) data.array[i] = segments[6 * Math.floor(i / 6 / corners) + (i % 6)];
    data.needsUpdate = true;
    geometry.setDrawRange(0, this.join(segments, geometry.index!));
  }

  /** Ends of segments are round where these do not go on in each other. The number of corners of all triangles. */
  private join(segments: Float32Array, index: BufferAttribute): number {
    const [end, middle, start] = [0, 6, 12].map((first) => segment.index!.array.slice(first, first + 6));
    let length = 0;
    const add = (part: typeof end, i: number) => part.forEach((corner) => (index.array[length++] = corners * i + corner));
    for (let i = 0; 6 * i < segments.length; ++i) {
      add(middle, i);
      if (!goesOn(segments, i)) add(start, i);
      if (!goesOn(segments, i + 1)) add(end, i);
    }
    index.needsUpdate = true;
    return length;
  }

  private makeRoom(room: number): void {
    this.room = room;
    const [{ geometry: before }] = this.lines;
    const geometry = new BufferGeometry();
    repeat(segment, room, ['position', 'uv'], geometry);
    const ends = new InterleavedBuffer(new Float32Array(6 * corners * room), 6);
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(ends, 3, 0)); // as the material calls the ends of a segment
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(ends, 3, 3));
    for (const line of this.lines) line.geometry = geometry;
    before.dispose();
  }
}
