// SPDX-License-Identifier: Apache-2.0
// The way of a body axis over the unit sphere, for both methods, the reference and the keys.
import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { once } from '../data/once';
import { isGap, type Method, type Path } from '../data/report';
import { element } from '../look/element';
import { coloursOf, type Colours } from '../look/theme';
import { wayOverSphere } from '../motion/lines';
import { isShownAt, orientationAt, ownTime, quaternionAt } from '../motion/orientation';
import type { Polyline } from '../motion/polyline';
import { bodyAxis, type Axis } from '../motion/quaternion';
import type { State, Store } from '../store/store';
import { Stage } from './stage';

const lift = 1.004; // paths lie on the sphere, not in it
const mostDots = 400; // of more keys some are left out, evenly
const towardsEye = { reference: 0, second: -600, first: -1200, keys: -1800 }; // steps of the depth buffer: which path hides which

interface PathLook {
  colour: string;
  width: number;
  offset: number;
}

/** The way of an axis, in the stretches between its gaps. */
function pathOf({ t, values }: Polyline, { colour, width, offset }: PathLook): Group {
  const material = new LineMaterial({ color: colour, linewidth: width, polygonOffset: true, polygonOffsetUnits: offset });
  const path = new Group();
  let first = 0;
  for (let i = 0; i <= t.length; ++i) {
    if (i < t.length && !Number.isNaN(values[3 * i])) continue;
    const points = values.subarray(3 * first, 3 * i).map((value) => lift * value);
    if (i - first > 1) path.add(new Line2(new LineGeometry().setPositions(Float32Array.from(points)), material));
    first = i + 1;
  }
  return path;
}

const directions = (path: Path, axis: Axis) =>
  Array.from(path.t.keys()).flatMap((i) => (isGap(path, i) ? [] : [new Vector3(...bodyAxis(quaternionAt(path, i), axis))]));

/** The whole sphere is to be in the picture. */
const outline = [1, -1].flatMap((end) => [new Vector3(end, 0, 0), new Vector3(0, end, 0), new Vector3(0, 0, end)]);

/** Parallels and meridians every 30 degrees. */
function graticule(colour: string): LineSegments {
  const degree = Math.PI / 180;
  const at = (longitude: number, latitude: number) =>
    new Vector3().setFromSphericalCoords(1, (90 - latitude) * degree, longitude * degree).applyAxisAngle(new Vector3(1, 0, 0), Math.PI / 2);
  const points: Vector3[] = [];
  for (let longitude = 0; longitude < 360; longitude += 6)
    for (let latitude = -60; latitude <= 60; latitude += 30) points.push(at(longitude, latitude), at(longitude + 6, latitude));
  for (let latitude = -90; latitude < 90; latitude += 6)
    for (let longitude = 0; longitude < 360; longitude += 30) points.push(at(longitude, latitude), at(longitude, latitude + 6));
  return new LineSegments(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({ color: colour }));
}

function globe(colours: Colours): Group {
  const ground = new MeshBasicMaterial({ color: colours.ground, transparent: true, opacity: 0.65 });
  return new Group().add(new Mesh(new SphereGeometry(0.995, 48, 32), ground), graticule(colours.grid));
}

function dotsAt(path: Path, axis: Axis, { colour, radius }: { colour: string; radius: number }): Group {
  const dots = new Group();
  const material = new MeshBasicMaterial({ color: colour, polygonOffset: true, polygonOffsetUnits: towardsEye.keys });
  const every = Math.ceil(path.t.length / mostDots);
  for (let i = 0; i < path.t.length; i += every) {
    const direction = new Vector3(...bodyAxis(quaternionAt(path, i), axis));
    const dot = new Mesh(new CircleGeometry(radius, 16), material);
    dot.position.copy(direction.clone().multiplyScalar(lift));
    dot.lookAt(direction.multiplyScalar(2));
    dots.add(dot);
  }
  return dots;
}

/** From the center of the sphere to where the axis points now. */
class Pointer {
  readonly object: Group;
  private readonly ray: Line;
  private readonly tip: Mesh;

  constructor(colour: string) {
    this.ray = new Line(new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(6), 3)), new LineBasicMaterial({ color: colour }));
    this.tip = new Mesh(new SphereGeometry(0.045, 20, 14), new MeshBasicMaterial({ color: colour }));
    this.ray.frustumCulled = false;
    this.object = new Group().add(this.ray, this.tip);
  }

  turnTo(direction: number[]): void {
    this.tip.position.fromArray(direction);
    const ends = this.ray.geometry.getAttribute('position') as BufferAttribute;
    ends.setXYZ(1, direction[0], direction[1], direction[2]);
    ends.needsUpdate = true;
  }
}

const wayOf = (axis: Axis) => once((path: Path) => wayOverSphere(path, axis));

export class SphereScene {
  readonly figure: HTMLElement;
  private readonly caption = element('strong');
  private readonly stage: Stage;
  private content?: Group;
  private pointers: { pointer: Pointer; method: Method }[] = [];
  private readonly ways = { x: wayOf('x'), y: wayOf('y'), z: wayOf('z') };

  constructor(private readonly store: Store) {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: 'sphere' }, element('figcaption', {}, this.caption), frame);
    this.stage = new Stage(store, frame);
    const { subscribe, methodNamed, report } = store;
    subscribe(['first', 'second', 'axis', 'theme'], (state) => this.rebuild(state));
    subscribe(['time'], (state) => this.showTime(state));
    subscribe(['axis'], ({ first, axis }) => this.stage.lookAt([...outline, ...directions(methodNamed(first)?.samples ?? report.keys, axis)]));
  }

  private rebuild(state: State): void {
    const { methodNamed, keysOf, report } = this.store;
    const colours = coloursOf(state);
    const wayOver = this.ways[state.axis];
    const content = new Group().add(globe(colours), dotsAt(keysOf(methodNamed(state.first)), state.axis, { colour: colours.ink, radius: 0.024 }));
    if (report.marks) content.add(dotsAt(report.marks, state.axis, { colour: colours.mark, radius: 0.036 }));
    const grey = { colour: colours.reference, width: 5, offset: towardsEye.reference };
    if (report.reference) content.add(pathOf(wayOver(report.reference), grey));
    this.pointers = [];
    for (const which of ['second', 'first'] as const) {
      const method = methodNamed(state[which]);
      if (!method) continue;
      const pointer = new Pointer(colours[which]);
      const look = { colour: colours[which], width: which === 'first' ? 2.5 : 2, offset: towardsEye[which] };
      content.add(pathOf(wayOver(method.samples), look), pointer.object);
      this.pointers.push({ pointer, method });
    }
    this.caption.textContent = `Body axis ${state.axis} on the unit sphere`;
    this.stage.describe(this.caption.textContent);
    this.stage.replace(this.content, content);
    this.content = content;
    this.showTime(state);
  }

  private showTime({ time, axis }: State): void {
    for (const { pointer, method } of this.pointers) {
      const own = ownTime(method.clock, time);
      pointer.object.visible = isShownAt(method.samples, own);
      if (pointer.object.visible) pointer.turnTo(bodyAxis(orientationAt(method.samples, own), axis));
    }
    this.stage.draw();
  }
}
