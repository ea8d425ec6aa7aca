// SPDX-License-Identifier: Apache-2.0
// The ground: squares of the world that fade away from the middle, and what is above them as a soft shadow. It shows where up is.
import { Color, DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector4 } from 'three';
import type { Colours } from '../look/theme';

const vertexShader = `
uniform float reach;
varying vec2 place;
void main() {
  place = reach * position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

/** Every fifth line is stronger. Lines that are too near to each other to be told apart fade. */
const fragmentShader = `
uniform vec3 ink;
uniform vec2 shift;
uniform float square, reach;
uniform vec4 shadow;
varying vec2 place;
float lines(vec2 at) {
  vec2 pixel = fwidth(at);
  vec2 line = clamp(1.0 - abs(fract(at - 0.5) - 0.5) / pixel + 0.1, 0.0, 1.0) * clamp(1.0 - 2.5 * pixel, 0.0, 1.0);
  return max(line.x, line.y);
}
void main() {
  vec2 at = (place + shift) / square;
  float grid = max(0.24 * lines(at), 0.45 * lines(at / 5.0)) * (1.0 - smoothstep(0.25, 1.0, length(place) / reach));
  vec2 off = (place - shadow.xy) / max(shadow.z, 1e-6);
  float shade = shadow.w * exp(-2.0 * dot(off, off));
  float both = grid + shade * (1.0 - grid);
  gl_FragColor = vec4(ink * grid / max(both, 1e-6), both);
  #include <colorspace_fragment>
}`;

export class Ground {
  readonly object: Mesh;
  private readonly uniforms = {
    ink: { value: new Color() },
    shift: { value: new Vector2() }, // of the squares
    square: { value: 1 },
    reach: { value: 1 },
    shadow: { value: new Vector4() }, // x, y, the radius, 0: none, and how dark it is
  };

  constructor() {
    const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms: this.uniforms, transparent: true, depthWrite: false, side: DoubleSide });
    this.object = new Mesh(new PlaneGeometry(2, 2), material);
    this.object.renderOrder = -1; // all else is above it
  }

  /** Lengths of the scene. */
  set({ height, square, reach }: { height: number; square: number; reach: number }): void {
    this.object.position.z = height;
    this.uniforms.square.value = square;
    this.uniforms.reach.value = reach;
    this.object.scale.set(reach, reach, 1);
  }

  /** The squares stand still in a world that is shifted so. */
  shift({ x, y }: { x: number; y: number }): void {
    this.uniforms.shift.value.set(x, y);
  }

  shade({ x, y }: { x: number; y: number }, radius: number): void {
    const { value } = this.uniforms.shadow;
    value.set(x, y, radius, value.w);
  }

  paint({ faint, ground }: Colours): void {
    this.uniforms.ink.value.set(faint);
    this.uniforms.shadow.value.w = new Color(ground).r > 0.5 ? 0.13 : 0.4; // on light or on dark ground
  }
}
