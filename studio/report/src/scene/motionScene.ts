// SPDX-License-Identifier: Apache-2.0
// The body of one method in space, with ghosts of it at the keys.
import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, Vector3, type Object3D } from 'three';
import { element } from '../element';
import { orientationAt, quaternionAt, vectorAt, type Quaternion } from '../motion';
import { methodNamed, report, type Method } from '../report';
import { subscribe, type State } from '../state';
import { coloursOf } from '../theme';
import { axes, body } from './body';
import { Stage } from './stage';

const turn = (object: Object3D, [w, x, y, z]: Quaternion) => object.quaternion.set(x, y, z, w);
const mostGhosts = 60; // keys beyond this are left out evenly
const ghostsAround = 2; // of the fixed body: this many keys before and after the time
const bodyLength = 0.045; // of the path's extent

/** The positions of the motion, scaled to fit into the view. */
class FlightPath {
  private readonly center: Vector3;
  readonly unit: number; // lengths of the scene per metre

  constructor(private readonly method: Method) {
    const points = Array.from({ length: method.samples.t.length }, (_, i) => new Vector3().fromArray(method.samples.p, 3 * i));
    const low = points.reduce((least, p) => least.min(p), points[0].clone());
    const high = points.reduce((most, p) => most.max(p), points[0].clone());
    this.center = low.clone().add(high).multiplyScalar(0.5);
    this.unit = 2.6 / Math.max(high.distanceTo(low), 1e-9);
  }

  at = (position: number[]) => new Vector3().fromArray(position).sub(this.center).multiplyScalar(this.unit);
  atTime = (t: number) => this.at(vectorAt(this.method.samples.t, this.method.samples.p, t));

  line(colour: string): Line {
    const { t, p } = this.method.samples;
    const points = new Float32Array(t.flatMap((_, i) => this.at(p.slice(3 * i, 3 * i + 3)).toArray()));
    return new Line(new BufferGeometry().setAttribute('position', new BufferAttribute(points, 3)), new LineBasicMaterial({ color: colour }));
  }
}

export class MotionScene {
  readonly figure: HTMLElement;
  private readonly name = element('strong');
  private readonly stage: Stage;
  private content?: Group;
  private moving?: Group;
  private ghosts: { object: Object3D; key: number }[] = [];
  private path?: FlightPath;

  constructor(private readonly which: 'first' | 'second') {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: which }, element('figcaption', {}, this.name), frame);
    this.stage = new Stage(frame);
    subscribe([which, 'theme', 'body', 'place'], (state) => this.rebuild(state));
    subscribe(['time'], (state) => this.showTime(state));
  }

  /** Both scenes are looked at from the same side. */
  linkCamera(other: MotionScene): void {
    const follow = (from: Stage, to: Stage) =>
      from.controls.addEventListener('change', () => {
        if (to.camera.position.distanceTo(from.camera.position) < 1e-9) return;
        to.camera.position.copy(from.camera.position);
        to.controls.update();
      });
    follow(this.stage, other.stage);
    follow(other.stage, this.stage);
  }

  private rebuild(state: State): void {
    const method = methodNamed(state[this.which]);
    this.figure.hidden = !method;
    this.name.textContent = method?.name ?? '';
    const content = new Group();
    this.ghosts = [];
    this.moving = undefined;
    if (method) this.fill(content, method, state);
    this.stage.replace(this.content, content);
    this.content = content;
    this.showTime(state);
  }

  private fill(content: Group, method: Method, state: State): void {
    const colours = coloursOf(state);
    this.path = state.place === 'path' && method.samples.p.length > 0 && report.keys.p.length > 0 ? new FlightPath(method) : undefined;
    const scale = this.path ? 2.6 * bodyLength * 2.2 : 1.3;
    this.moving = body(state.body, { colour: colours[this.which], opacity: 1 }, colours);
    this.moving.scale.setScalar(this.path ? 1.5 * scale : scale);
    content.add(this.moving, this.path ? this.path.line(colours[this.which]) : axes({ ...colours, x: colours.grid, y: colours.grid, z: colours.grid }, 1.15));
    const every = this.path ? Math.ceil(report.keys.t.length / mostGhosts) : 1;
    for (let key = 0; key < report.keys.t.length; key += every) {
      const object = body(state.body, { colour: colours.faint, opacity: this.path ? 0.45 : 0.16 }, colours);
      object.scale.setScalar(scale);
      turn(object, quaternionAt(report.keys, key));
      if (this.path) object.position.copy(this.path.at(report.keys.p.slice(3 * key, 3 * key + 3)));
      this.ghosts.push({ object, key });
      content.add(object);
    }
  }

  private showTime(state: State): void {
    const method = methodNamed(state[this.which]);
    if (!method || !this.moving) return;
    turn(this.moving, orientationAt(method.samples, state.time));
    if (this.path) this.moving.position.copy(this.path.atTime(state.time));
    else this.showNearGhosts(state.time);
    this.stage.draw();
  }

  private showNearGhosts(time: number): void {
    const next = report.keys.t.findIndex((t) => t > time);
    const middle = next < 0 ? report.keys.t.length : next;
    for (const { object, key } of this.ghosts) object.visible = key >= middle - ghostsAround && key < middle + ghostsAround;
  }
}
