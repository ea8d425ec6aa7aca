// SPDX-License-Identifier: Apache-2.0
// The body of one method in space, with ghosts of it at the keys.
import { Group, Vector3, type Object3D } from 'three';
import { hasPositions, type Keys, type Method } from '../data/report';
import { breakable, element } from '../look/element';
import { coloursOf } from '../look/theme';
import { isShownAt, orientationAt, ownTime, quaternionAt, spanAt } from '../motion/orientation';
import type { Quaternion } from '../motion/quaternion';
import type { State, Store } from '../store/store';
import { axes, body } from './body';
import { FlightPath } from './flightPath';
import { Stage } from './stage';

/** How the body and its ghosts are drawn; lengths of the scene. */
const looks = {
  follow: { body: 0.75, ghost: 0.6, opacity: 0.3, path: { step: 0.8 }, view: 1.75 },
  path: { body: 0.3, ghost: 0.13, opacity: 0.5, path: { whole: 2.6 }, view: 2.6 },
  fixed: { body: 1.3, ghost: 1.3, opacity: 0.14 },
};
const mostGhosts = 200; // of more keys some are left out, evenly
const ghostsAround = 2; // in one place: this many keys before and after the time

const turn = (object: Object3D, [w, x, y, z]: Quaternion) => object.quaternion.set(x, y, z, w);

/** What a body that turns in one place may fill. */
const fixedOutline = [1, -1].flatMap((end) => [new Vector3(0.65 * end, -0.45 * end, 0), new Vector3(0, 0, 0.72 * end)]);

export class MotionScene {
  readonly figure: HTMLElement;
  private readonly name = element('strong');
  private readonly stage: Stage;
  private content?: Group;
  private moving?: Object3D;
  private track = new Group(); // what stands still in the world
  private ghosts: Object3D[] = [];
  private keys: Keys;
  private path?: FlightPath;

  constructor(
    private readonly store: Store,
    private readonly which: 'first' | 'second',
  ) {
    this.keys = store.report.keys;
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: which }, element('figcaption', {}, this.name), frame);
    this.stage = new Stage(store, frame);
    const { subscribe } = store;
    subscribe([which, 'theme', 'body', 'place'], (state) => this.rebuild(state));
    subscribe(['place'], ({ place }) => this.stage.lookAt(place !== 'fixed' && this.path ? this.path.outline(looks[place].view) : fixedOutline));
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
    const method = this.store.methodNamed(state[this.which]);
    this.figure.hidden = !method;
    this.name.replaceChildren(...breakable(method?.name ?? ''));
    this.stage.describe(`The body in space, moved by ${method?.name ?? 'no method'}`);
    const content = new Group();
    this.moving = undefined;
    this.path = undefined;
    if (method) this.fill(content, method, state);
    this.stage.replace(this.content, content);
    this.content = content;
    this.showTime(state);
  }

  private fill(content: Group, method: Method, state: State): void {
    const colours = coloursOf(state);
    const place = hasPositions(method) ? state.place : 'fixed';
    const look = looks[place];
    if (place !== 'fixed') this.path = new FlightPath(method, looks[place].path);
    this.keys = method.keys;
    this.moving = body(state.body, { colour: colours[this.which], opacity: 1 }, colours);
    this.moving.scale.setScalar(look.body);
    this.ghosts = this.makeGhosts(look.ghost, () => body(state.body, { colour: colours.faint, opacity: look.opacity }, colours));
    this.track = new Group().add(...this.ghosts);
    if (this.path) this.track.add(this.path.line(colours[this.which]));
    else this.track.add(axes({ ...colours, x: colours.faint, y: colours.faint, z: colours.faint }, 0.8));
    content.add(this.track, this.moving);
  }

  private makeGhosts(scale: number, make: () => Object3D): Object3D[] {
    const keys = this.keys.t.length;
    const every = this.path ? Math.ceil(keys / mostGhosts) : 1;
    return Array.from({ length: this.path ? Math.ceil(keys / every) : Math.min(2 * ghostsAround, keys) }, (_, k) => {
      const object = make();
      object.scale.setScalar(scale);
      turn(object, quaternionAt(this.keys, k * every));
      if (this.path) object.position.copy(this.path.atKey(k * every));
      return object;
    });
  }

  private showTime({ time, place, ...state }: State): void {
    const method = this.store.methodNamed(state[this.which]);
    if (!method || !this.moving) return;
    const own = ownTime(method.clock, time);
    this.moving.visible = isShownAt(method.samples, own);
    if (this.moving.visible) turn(this.moving, orientationAt(method.samples, own));
    if (!this.path) this.turnGhosts(own);
    else if (place === 'follow') this.track.position.copy(this.path.atTime(own)).negate();
    else this.moving.position.copy(this.path.atTime(own));
    this.stage.draw();
  }

  /** To the keys around the time. */
  private turnGhosts(time: number): void {
    const first = spanAt(this.keys.t, time) + 1 - ghostsAround;
    this.ghosts.forEach((ghost, k) => {
      ghost.visible = first + k >= 0 && first + k < this.keys.t.length;
      if (ghost.visible) turn(ghost, quaternionAt(this.keys, first + k));
    });
  }
}
