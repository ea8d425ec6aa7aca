// SPDX-License-Identifier: Apache-2.0
// The body of one method in space, with ghosts of it at the keys.
import { Fog, Group, Vector3 } from 'three';
import { once } from '../data/once';
import { hasPositions, type Keys, type Method } from '../data/report';
import { breakable, element } from '../look/element';
import { chosen, roundStep } from '../look/number';
import { coloursOf } from '../look/theme';
import { isShownAt, orientationAt, ownTime, quaternionAt, spanAt } from '../motion/orientation';
import type { State, Store } from '../store/store';
import { Bodies } from './bodies';
import { FlightPath } from './flightPath';
import { Ground } from './ground';
import type { Painter } from './painter';
import type { Shapes } from './shapes';
import { Stage } from './stage';
import { Trail } from './trail';
import { ball, eyeAcross, type View } from './view';

type Place = State['place'];

/** How the body and its ghosts are drawn; lengths of the scene. Ghosts are at this many keys before and after the time, or at all. */
const looks: Record<Place, { body: number; ghost: number; opacity: number; around: number; reach: number }> = {
  follow: { body: 0.75, ghost: 0.6, opacity: 0.24, around: 12, reach: 5 },
  path: { body: 0.42, ghost: 0.16, opacity: 0.4, around: Infinity, reach: 3 },
  fixed: { body: 1, ghost: 1, opacity: 0.13, around: 2, reach: 2.4 },
};
const step = 0.8; // of keys, where the body is followed
const whole = 2.6; // of the whole path
const mostGhosts = 24; // of more keys some are left out, evenly
const below = 0.72; // the ground, of the size of the body
const halfWidth = { width: 0.55, height: 0.86 }; // of the picture, for a body
const bodyRadius = 0.6; // of its size
const fromTheFront = new Vector3(0.62, -1, 0.62).normalize();
const fixedSquare = 0.25;

/** A path has a scale for each way to see it. */
const followed = once((method: Method) => new FlightPath(method, { step }));
const asWhole = once((method: Method) => new FlightPath(method, { whole }));

function viewOf(place: Place, path: FlightPath | undefined): View {
  const outline = path?.outline() ?? [];
  const eye = path ? eyeAcross(outline) : fromTheFront;
  return place === 'path' ? { eye, points: outline } : { eye, points: ball(bodyRadius * looks[place].body), share: halfWidth };
}

/** As long as one can say. */
const lengthOf = (metres: number) => (metres >= 1000 ? `${chosen(metres / 1000)} km` : metres < 0.01 ? `${chosen(metres * 1000)} mm` : metres < 1 ? `${chosen(metres * 100)} cm` : `${chosen(metres)} m`);

export class MotionScene {
  readonly figure: HTMLElement;
  private readonly name = element('strong');
  private readonly scale = element('small', { className: 'scale' });
  private readonly stage: Stage;
  private readonly ground = new Ground();
  private readonly fog = new Fog(0xffffff); // hides what is far along the path
  private readonly track = new Group(); // what stands still in the world
  private readonly way = new Trail({ width: 2.5, order: 2, fog: true });
  private readonly wayBelow = new Trail({ width: 1.5, strength: 0.4, order: -1 }); // on the ground
  private readonly drop = new Trail({ width: 1, strength: 0.6, order: 2 }); // from the body to it
  private body!: Bodies;
  private ghosts!: Bodies;
  private method?: Method;
  private place: Place = 'fixed';
  private path?: FlightPath;
  private floor = 0; // height of the ground

  constructor(
    private readonly store: Store,
    painter: Painter,
    private readonly shapes: Shapes,
    private readonly which: 'first' | 'second',
  ) {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: which }, element('figcaption', {}, this.name), frame);
    this.stage = new Stage(store, painter, frame);
    frame.append(this.scale);
    this.stage.scene.onBeforeRender = () => {
      this.fog.near = this.stage.camera.position.length();
      this.fog.far = this.fog.near + looks.follow.reach;
    };
    this.track.add(this.way.object, this.wayBelow.object);
    this.stage.scene.add(this.ground.object, this.track, this.drop.object);
    const { subscribe } = store;
    subscribe(['body'], (state) => this.reshape(state));
    subscribe([which, 'place'], (state) => this.arrange(state));
    subscribe([which, 'place', 'body', 'theme'], (state) => this.paint(state));
    subscribe([which, 'place', 'body', 'theme', 'time'], (state) => this.showTime(state));
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

  private reshape({ body }: State): void {
    for (const before of [this.body, this.ghosts]) {
      before?.object.removeFromParent();
      before?.dispose();
    }
    const parts = this.shapes.of(body);
    this.body = new Bodies(parts, 1, true);
    this.ghosts = new Bodies(parts.filter(({ isDetail }) => !isDetail), mostGhosts, false);
    this.track.add(this.ghosts.object);
    this.stage.scene.add(this.body.object);
  }

  private arrange(state: State): void {
    const method = this.store.methodNamed(state[this.which]);
    this.figure.hidden = !method;
    const isFirst = !this.method;
    this.method = method;
    if (!method) return;
    this.name.replaceChildren(...breakable(method.name));
    this.stage.describe(`The body in space, moved by ${method.name}`);
    const place = hasPositions(method) ? state.place : 'fixed';
    const isOther = isFirst || place !== this.place;
    this.place = place;
    this.path = place === 'fixed' ? undefined : (place === 'path' ? asWhole : followed)(method);
    this.layGround();
    this.way.set(this.path?.line ?? new Float32Array());
    this.wayBelow.set(place === 'path' ? this.path!.line : new Float32Array());
    this.wayBelow.object.scale.z = 1e-6;
    this.wayBelow.object.position.z = this.floor;
    if (isOther) this.stage.lookAt(viewOf(place, this.path));
  }

  /** Below the body, or below its whole path. Its squares are of the world where there are positions. */
  private layGround(): void {
    const { body, reach } = looks[this.place];
    this.floor = this.place === 'path' ? this.path!.low - 0.5 * body : -below * body;
    const square = this.path ? roundStep((0.7 * body) / this.path.unit) : 0;
    this.ground.set({ height: this.floor, square: this.path ? square * this.path.unit : fixedSquare, reach });
    this.scale.textContent = square > 0 ? `squares of ${lengthOf(square)}` : '';
  }

  private paint(state: State): void {
    const colours = coloursOf(state);
    const own = colours[this.which];
    this.body.paint(own, colours);
    this.ghosts.paint(colours.faint, colours, looks[this.place].opacity);
    this.ground.paint(colours);
    this.way.paint(own, colours);
    this.wayBelow.paint(colours.faint, colours);
    this.drop.paint(colours.faint, colours);
    this.fog.color.set(colours.ground);
    this.stage.scene.fog = this.place === 'follow' ? this.fog : null;
  }

  private showTime({ time }: State): void {
    const { method, path, place } = this;
    if (!method) return;
    const { body } = looks[place];
    const own = ownTime(method.clock, time);
    const isShown = isShownAt(method.samples, own);
    const at = path?.atTime(own) ?? new Vector3();
    const isOnPath = place === 'path';
    const here = isOnPath ? at : new Vector3();
    if (place === 'follow') this.ground.shift(at);
    this.track.position.copy(place === 'follow' ? at.clone().negate() : new Vector3());
    this.body.object.visible = isShown;
    if (isShown) this.body.place(0, orientationAt(method.samples, own), body, here);
    this.ground.shade(here, isShown ? 0.6 * body : 0);
    this.drop.set(isOnPath && isShown ? Float32Array.of(...here.toArray(), here.x, here.y, this.floor) : new Float32Array());
    this.showGhosts(method.keys, own);
    this.stage.draw();
  }

  private showGhosts(keys: Keys, time: number): void {
    const { ghost, around } = looks[this.place];
    const count = keys.t.length;
    const now = spanAt(keys.t, time) + 1;
    const [first, last] = [Math.max(now - around, 0), Math.min(now + around, count)];
    const every = Math.ceil((last - first) / mostGhosts);
    let shown = 0;
    for (let key = first; key < last; key += every) this.ghosts.place(shown++, quaternionAt(keys, key), ghost, this.path?.atKey(key));
    this.ghosts.show(shown);
  }
}
