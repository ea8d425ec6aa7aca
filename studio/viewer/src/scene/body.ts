// SPDX-License-Identifier: Apache-2.0
// The body: x forward, y left, z up, about 1 long.
import {
  ArrowHelper,
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  EdgesGeometry,
  ExtrudeGeometry,
  Group,
  LatheGeometry,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  Shape,
  Vector2,
  Vector3,
} from 'three';
import type { BodyShape } from '../data/report';
import type { Colours } from '../look/theme';

export interface Look {
  colour: string;
  opacity: number;
}

function part(geometry: BufferGeometry, { colour, opacity }: Look, shade = 1): Mesh {
  const ghost = opacity < 1;
  const material = new MeshStandardMaterial({
    color: new Color(colour).multiplyScalar(shade),
    roughness: 0.65,
    metalness: 0.05,
    transparent: ghost,
    opacity,
    depthWrite: !ghost,
  });
  return new Mesh(geometry, material);
}

/** A flat outline [x, y], given thickness along z. */
function plate(outline: [number, number][], thickness: number): ExtrudeGeometry {
  const shape = new Shape();
  outline.forEach(([x, y], i) => (i === 0 ? shape.moveTo(x, y) : shape.lineTo(x, y)));
  return new ExtrudeGeometry(shape, { depth: thickness, bevelEnabled: false }).translate(0, 0, -thickness / 2);
}

/** Radius and place along x, from the nose to the tail. */
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

function aircraft(look: Look): Group {
  const hull = new LatheGeometry(fuselage.map(([radius, x]) => new Vector2(radius, x)).reverse(), 24).rotateZ(-Math.PI / 2);
  const canopy = part(new CapsuleGeometry(0.045, 0.14, 4, 12).rotateZ(Math.PI / 2).translate(0.22, 0, 0.055), look, 0.3);
  return new Group().add(
    part(hull, look),
    ...(look.opacity < 1 ? [] : [canopy]),
    part(plate(wings, 0.025), look, 0.92),
    part(plate(tailplane, 0.02), look, 0.92),
    part(plate(fin, 0.02).rotateX(Math.PI / 2), look, 0.75),
  );
}

function box(look: Look): Group {
  const geometry = new BoxGeometry(0.9, 0.6, 0.3);
  const edges = new LineSegments(
    new EdgesGeometry(geometry),
    new LineBasicMaterial({ color: new Color(look.colour).multiplyScalar(0.5), transparent: true, opacity: look.opacity }),
  );
  return new Group().add(part(geometry, look), edges);
}

export function axes(colours: Colours, length: number): Group {
  const arrow = (direction: Vector3, colour: string) => new ArrowHelper(direction, new Vector3(), length, colour, 0.16 * length, 0.09 * length);
  return new Group().add(
    arrow(new Vector3(1, 0, 0), colours.x),
    arrow(new Vector3(0, 1, 0), colours.y),
    arrow(new Vector3(0, 0, 1), colours.z),
  );
}

/** Solid bodies have axes of their own; ghosts are only outlines of the past and the future. */
export function body(shape: BodyShape, look: Look, colours: Colours): Group {
  if (shape === 'axes') return axes(colours, look.opacity < 1 ? 0.35 : 0.55);
  return new Group().add(shape === 'box' ? box(look) : aircraft(look));
}
