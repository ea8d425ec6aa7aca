// SPDX-License-Identifier: Apache-2.0
// What is on the unit sphere. Its front half hides the other one, so that what lies behind is drawn again, thin and faint.
import { BufferGeometry, CircleGeometry, Color, GreaterDepth, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, ShaderMaterial, SphereGeometry, Vector3 } from 'three';
import { once } from '../data/once';
import { isGap, type Path } from '../data/report';
import type { Colours } from '../look/theme';
import { wayOverSphere } from '../motion/lines';
import { quaternionAt } from '../motion/orientation';
import { bodyAxis, type Axis } from '../motion/quaternion';
import { axisNames, zUp, type Overlay } from './overlay';
import { repeat } from './repeated';
import { thinned } from './thinned';
import { Trail } from './trail';
import { ball } from './view';

export const lift = 1.004; // paths lie on the sphere, not in it
/** Behind the sphere's front: what was drawn before is nearer. */
const behind = { depthFunc: GreaterDepth, fog: false } as const;
const faint = 0.42;
const inFront = 20; // later than all that is behind
const axisLength = 1.13;
const apart = 2.8; // radii of dots, else they are one black line
const nameAt = 1.21; // of an axis
const unseen = 3.5e-4; // of the radius: 0.02 degrees, a twentieth of a pixel

/** What a picture of the sphere is to hold. */
export const globeOutline = [...ball(1.02), ...Object.values(zUp).map((axis) => axis.clone().multiplyScalar(nameAt + 0.07))];

export function nameAxes(overlay: Overlay): void {
  for (const axis of axisNames) overlay.name(axis, zUp[axis].clone().multiplyScalar(nameAt));
}

const wayOf = (axis: Axis) => once((path: Path) => thinned(new Float32Array(wayOverSphere(path, axis).values.map((value) => lift * value)), unseen));

/** The way of a body axis, as a trail takes it. */
export const waysOf = { x: wayOf('x'), y: wayOf('y'), z: wayOf('z') };

const mostDirections = 500; // that say from where the sphere is seen best

export function directionsOf(path: Path, axis: Axis): Vector3[] {
  const directions: Vector3[] = [];
  const every = Math.ceil(path.t.length / mostDirections);
  for (let i = 0; i < path.t.length; i += every) if (!isGap(path, i)) directions.push(new Vector3(...bodyAxis(quaternionAt(path, i), axis)));
  return directions;
}
const mostDots = 400; // of more keys some are left out, evenly

/** On the sphere, full before it and faint behind. */
export const wayOnSphere = (width: number, order: number) => new Trail({ width: 0.55 * width, strength: faint, order, ...behind }, { width, order: inFront + order });

/** Parallels and meridians every 30 degrees. */
function graticule(): BufferGeometry {
  const degree = Math.PI / 180;
  const at = (longitude: number, latitude: number) =>
    new Vector3().setFromSphericalCoords(1, (90 - latitude) * degree, longitude * degree).applyAxisAngle(new Vector3(1, 0, 0), Math.PI / 2);
  const points: Vector3[] = [];
  for (let longitude = 0; longitude < 360; longitude += 6)
    for (let latitude = -60; latitude <= 60; latitude += 30) points.push(at(longitude, latitude), at(longitude + 6, latitude));
  for (let latitude = -90; latitude < 90; latitude += 6)
    for (let longitude = 0; longitude < 360; longitude += 30) points.push(at(longitude, latitude), at(longitude, latitude + 6));
  return new BufferGeometry().setFromPoints(points);
}

const vertexShader = `
varying vec3 towards, side;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  towards = -seen.xyz;
  side = normalMatrix * normal;
  gl_Position = projectionMatrix * seen;
}`;

/** Darker towards its rim, from whichever side it is seen. */
const fragmentShader = `
uniform vec3 ground, rim;
varying vec3 towards, side;
void main() {
  float turned = 1.0 - dot(normalize(towards), normalize(side));
  gl_FragColor = vec4(mix(ground, rim, 0.03 + 0.3 * turned * turned * turned), 1.0);
  #include <colorspace_fragment>
}`;

/** The sphere with its lines, and the axes of the world through it. */
export class Globe {
  readonly object = new Group();
  private readonly uniforms = { ground: { value: new Color() }, rim: { value: new Color() } };
  private readonly lines = [{ opacity: 0.08, ...behind }, { opacity: 0.22 }].map((look) => new LineBasicMaterial({ transparent: true, depthWrite: false, ...look }));
  private readonly axes = axisNames.map((axis) => ({ axis, trail: wayOnSphere(1.6, 3) }));

  constructor() {
    const grid = graticule();
    this.object.add(
      new Mesh(new SphereGeometry(0.995, 48, 32), new ShaderMaterial({ vertexShader, fragmentShader, uniforms: this.uniforms })),
      ...this.lines.map((material, i) => Object.assign(new LineSegments(grid, material), { renderOrder: i * inFront })),
      ...this.axes.map(({ axis, trail }) => {
        trail.set(Float32Array.of(0, 0, 0, ...zUp[axis].clone().multiplyScalar(axisLength).toArray()));
        return trail.object;
      }),
    );
  }

  paint(colours: Colours): void {
    this.uniforms.ground.value.set(colours.ground);
    this.uniforms.rim.value.set(colours.faint);
    for (const material of this.lines) material.color.set(colours.faint);
    for (const { axis, trail } of this.axes) trail.paint(colours[axis], colours);
  }
}

const disc = new CircleGeometry(1, 16);
const rim = disc.getAttribute('position');

/** Keys, on the sphere. */
export class Dots {
  readonly object = new Group();
  private readonly meshes: Mesh<BufferGeometry, MeshBasicMaterial>[];
  private readonly geometry = new BufferGeometry();

  constructor(
    private readonly radius: number,
    order: number,
  ) {
    repeat(disc, mostDots, ['position'], this.geometry);
    this.meshes = [{ opacity: faint, ...behind }, {}].map((look, i) => {
      const mesh = new Mesh(this.geometry, new MeshBasicMaterial({ transparent: true, depthWrite: false, ...look }));
      mesh.frustumCulled = false;
      mesh.renderOrder = order + i * inFront;
      return mesh;
    });
    this.object.add(...this.meshes);
  }

  set(path: Path, axis: Axis): void {
    const every = Math.ceil(path.t.length / mostDots);
    const [turned, up] = [new Matrix4(), new Vector3(0, 0, 1)];
    const [last, corner] = [new Vector3(), new Vector3()];
    const places = this.geometry.getAttribute('position');
    let count = 0;
    for (let i = 0; i < path.t.length; i += every) {
      if (isGap(path, i)) continue;
      const direction = new Vector3(...bodyAxis(quaternionAt(path, i), axis));
      if (direction.distanceTo(last) < apart * this.radius) continue;
      last.copy(direction);
      turned.lookAt(direction, new Vector3(), Math.abs(direction.z) < 0.9 ? up : new Vector3(1, 0, 0));
      turned.scale(new Vector3(this.radius, this.radius, 1)).setPosition(direction.multiplyScalar(lift));
      for (let k = 0; k < rim.count; ++k) corner.fromBufferAttribute(rim, k).applyMatrix4(turned).toArray(places.array, 3 * (count * rim.count + k));
      ++count;
    }
    this.geometry.setDrawRange(0, count * disc.index!.count);
    places.needsUpdate = true;
  }

  paint(colour: string): void {
    for (const { material } of this.meshes) material.color.set(colour);
  }
}

/** From the middle of the sphere to where an axis points now. */
export class Pointer {
  readonly object = new Group();
  private readonly ray = new Trail({ width: 1.6, strength: 0.55, order: 6, depthFunc: GreaterDepth, fog: false });
  private readonly tips = [{ opacity: 0.5, ...behind }, {}].map((look, i) => {
    const tip = new Mesh(new SphereGeometry(0.05, 14, 10), new MeshBasicMaterial({ transparent: true, depthWrite: false, ...look }));
    tip.renderOrder = 8 + i * inFront;
    return tip;
  });

  constructor() {
    this.object.add(this.ray.object, ...this.tips);
  }

  turnTo(direction: number[]): void {
    for (const tip of this.tips) tip.position.fromArray(direction);
    this.ray.set(Float32Array.of(0, 0, 0, ...direction));
  }

  paint(colour: string, colours: Colours): void {
    this.ray.paint(colour, colours);
    for (const { material } of this.tips) (material as MeshBasicMaterial).color.set(colour);
  }
}
