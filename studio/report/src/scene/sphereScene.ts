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
import { element } from '../element';
import { bodyAxis, orientationAt, quaternionAt, type Axis } from '../motion';
import { methodNamed, report, type Path } from '../report';
import { subscribe, type State } from '../state';
import { coloursOf, type Colours } from '../theme';
import { Stage } from './stage';

const lift = 1.004; // paths lie on the sphere, not in it

function pathOf(path: Path, axis: Axis, colour: string, width: number): Line2 {
  const points = path.t.flatMap((_, i) => bodyAxis(quaternionAt(path, i), axis).map((v) => lift * v));
  return new Line2(new LineGeometry().setPositions(points), new LineMaterial({ color: colour, linewidth: width }));
}

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
  const ground = new MeshBasicMaterial({ color: colours.ground, transparent: true, opacity: 0.82 });
  return new Group().add(new Mesh(new SphereGeometry(0.995, 48, 32), ground), graticule(colours.grid));
}

function keyDots(axis: Axis, colours: Colours): Group {
  const dots = new Group();
  const material = new MeshBasicMaterial({ color: colours.ink });
  for (let key = 0; key < report.keys.t.length; ++key) {
    const direction = new Vector3(...bodyAxis(quaternionAt(report.keys, key), axis));
    const dot = new Mesh(new CircleGeometry(0.022, 16), material);
    dot.position.copy(direction.clone().multiplyScalar(1.008));
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

export class SphereScene {
  readonly figure: HTMLElement;
  private readonly caption = element('strong');
  private readonly stage: Stage;
  private content?: Group;
  private pointers: { pointer: Pointer; path: Path }[] = [];

  constructor() {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: 'sphere' }, element('figcaption', {}, this.caption), frame);
    this.stage = new Stage(frame);
    subscribe(['first', 'second', 'axis', 'theme'], (state) => this.rebuild(state));
    subscribe(['time'], (state) => this.showTime(state));
  }

  private rebuild(state: State): void {
    const colours = coloursOf(state);
    const content = new Group().add(globe(colours), keyDots(state.axis, colours));
    if (report.reference && report.reference.t.length > 1) content.add(pathOf(report.reference, state.axis, colours.reference, 4));
    this.pointers = [];
    for (const which of ['second', 'first'] as const) {
      const method = methodNamed(state[which]);
      if (!method) continue;
      const pointer = new Pointer(colours[which]);
      content.add(pathOf(method.samples, state.axis, colours[which], which === 'first' ? 2.5 : 2), pointer.object);
      this.pointers.push({ pointer, path: method.samples });
    }
    this.caption.textContent = `Body axis ${state.axis} on the unit sphere`;
    this.stage.replace(this.content, content);
    this.content = content;
    this.showTime(state);
  }

  private showTime({ time, axis }: State): void {
    for (const { pointer, path } of this.pointers) pointer.turnTo(bodyAxis(orientationAt(path, time), axis));
    this.stage.draw();
  }
}
