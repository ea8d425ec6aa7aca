// SPDX-License-Identifier: Apache-2.0
// Shapes of bodies: x forward, y left, z up, about 1 long; a camera looks along -z, y up, as those of three.js, Blender and OpenGL do. A box has a
// nose, and says nothing of what it stands for.
import { ExtrudeGeometry, LatheGeometry, Shape, SphereGeometry, Vector2, type BufferGeometry } from 'three';
import type { BodyShape } from '../data/report';
import type { Axis } from '../motion/quaternion';

export interface Part {
  geometry: BufferGeometry;
  paint: number | Axis; // a shade of the body's colour, or the colour of an axis
  isDetail?: boolean; // ghosts do without
}

/** A flat outline [x, y], given thickness along z; its edges are broken by the bevel. */
function plate(outline: [number, number][], thickness: number, bevel = 0): ExtrudeGeometry {
  const shape = new Shape();
  outline.forEach(([x, y], i) => (i === 0 ? shape.moveTo(x, y) : shape.lineTo(x, y)));
  const depth = thickness - 2 * bevel;
  const edges = { bevelEnabled: bevel > 0, bevelSize: bevel, bevelThickness: bevel, bevelOffset: -bevel, bevelSegments: 2 };
  return new ExtrudeGeometry(shape, { depth, ...edges }).translate(0, 0, -depth / 2);
}

/** Radius and place along x, turned about x. */
const turned = (profile: [number, number][], segments: number) => new LatheGeometry(profile.map(([radius, x]) => new Vector2(radius, x)).reverse(), segments).rotateZ(-Math.PI / 2);

/** Along each axis of the body, from and to a distance from its middle. */
function arrows(from: number, lengths: Record<Axis, number>, isDetail: boolean): Part[] {
  const along = (length: number) => turned([[0, length], [0.042, length - 0.12], [0.042, length - 0.12], [0.015, length - 0.12], [0.015, from], [0, from]], 16);
  return [
    { geometry: along(lengths.x), paint: 'x', isDetail },
    { geometry: along(lengths.y).rotateZ(Math.PI / 2), paint: 'y', isDetail },
    { geometry: along(lengths.z).rotateY(-Math.PI / 2), paint: 'z', isDetail },
  ];
}

const fuselage: [number, number][] = [
  [0, 0.56],
  [0.028, 0.53],
  [0.052, 0.46],
  [0.07, 0.34],
  [0.076, 0.18],
  [0.074, -0.1],
  [0.052, -0.38],
  [0.028, -0.56],
  [0, -0.57],
];
const wings: [number, number][] = [
  [0.2, 0],
  [-0.12, 0.58],
  [-0.26, 0.58],
  [-0.16, 0],
  [-0.26, -0.58],
  [-0.12, -0.58],
];
const tailplane: [number, number][] = [
  [-0.34, 0],
  [-0.46, 0.22],
  [-0.54, 0.22],
  [-0.5, 0],
  [-0.54, -0.22],
  [-0.46, -0.22],
];
const fin: [number, number][] = [
  [-0.3, 0],
  [-0.46, 0.26],
  [-0.55, 0.26],
  [-0.52, 0],
];
const sides: [number, number][] = [
  [0.46, 0.08],
  [0.46, -0.08],
  [0.2, -0.29],
  [-0.42, -0.29],
  [-0.42, 0.29],
  [0.2, 0.29],
];

const cone: [number, number][] = [
  [0.2, 0.56],
  [0.26, 0.54],
  [0.13, 0.24],
  [0, 0.24],
];
const housing: [number, number][] = [
  [0.17, 0.2],
  [-0.17, 0.2],
  [-0.17, -0.2],
  [0.17, -0.2],
];
const finder: [number, number][] = [
  [0.06, 0.2],
  [0, 0.3],
  [-0.06, 0.2],
];

const made: Record<BodyShape, () => Part[]> = {
  aircraft: () => [
    { geometry: turned(fuselage, 24), paint: 1 },
    { geometry: plate(wings, 0.025), paint: 0.92 },
    { geometry: plate(tailplane, 0.02), paint: 0.92 },
    { geometry: plate(fin, 0.02).rotateX(Math.PI / 2), paint: 0.75 },
    { geometry: new SphereGeometry(0.05, 16, 12).scale(2.4, 1, 1).translate(0.22, 0, 0.055), paint: 0.3, isDetail: true },
  ],
  box: () => [{ geometry: plate(sides, 0.26, 0.03), paint: 1 }, ...arrows(0.1, { x: 0.7, y: 0.52, z: 0.4 }, true)],
  camera: () => [
    { geometry: plate(housing, 0.6, 0.03).translate(0, 0, 0.05), paint: 1 },
    { geometry: turned(cone, 4).rotateX(Math.PI / 4).rotateY(Math.PI / 2), paint: 0.75 },
    { geometry: plate(finder, 0.2).translate(0, 0, 0.05), paint: 0.92 },
    ...arrows(0.1, { x: 0.42, y: 0.5, z: 0.55 }, true),
  ],
  axes: () => [{ geometry: new SphereGeometry(0.045, 16, 12), paint: 1 }, ...arrows(0, { x: 0.58, y: 0.58, z: 0.58 }, false)],
};

/** The parts of each shape, made once for all bodies of a viewer. */
export class Shapes {
  private readonly parts = new Map<BodyShape, Part[]>();

  of(shape: BodyShape): Part[] {
    if (!this.parts.has(shape)) this.parts.set(shape, made[shape]());
    return this.parts.get(shape)!;
  }
}
