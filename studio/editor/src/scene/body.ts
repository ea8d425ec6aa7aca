// SPDX-License-Identifier: Apache-2.0
// The body in space, moved by the curve, and that of the other one where it differs; the chosen key with its gizmo, and the keys beside it.
import { Group, Vector3 } from 'three';
import { once } from 'orispline-viewer/data/once';
import { hasPositions, type BodyShape, type Method } from 'orispline-viewer/data/report';
import { element, menu } from 'orispline-viewer/look/element';
import { roundStep } from 'orispline-viewer/look/number';
import { isShownAt, orientationAt, vectorAt } from 'orispline-viewer/motion/orientation';
import { angleBetween, type Up } from 'orispline-viewer/motion/quaternion';
import { FlightPath } from 'orispline-viewer/scene/flightPath';
import { Bodies } from 'orispline-viewer/scene/bodies';
import { Ground } from 'orispline-viewer/scene/ground';
import type { Painter } from 'orispline-viewer/scene/painter';
import { Shapes } from 'orispline-viewer/scene/shapes';
import type { Stage } from 'orispline-viewer/scene/stage';
import { Trail } from 'orispline-viewer/scene/trail';
import { ball, standing, vertical } from 'orispline-viewer/scene/view';
import type { State as ViewState } from 'orispline-viewer/store/store';
import { keyWith, type Key, type Quaternion } from '../document/document';
import type { Studio } from '../store/studio';
import { TurnByHand } from './edit';
import { figureWith } from './figure';
import { Gizmo, type Space } from './gizmo';
import { keysBeside, Neighbours } from './neighbours';

const shapes: [BodyShape, string][] = [['box', 'box'], ['axes', 'axes'], ['aircraft', 'aircraft'], ['camera', 'camera']];
const ups: [Up, string][] = [['z', 'z up'], ['y', 'y up']];
const spaces: [Space, string][] = [['world', 'world axes'], ['local', 'body axes']];
/** Lengths of the scene: in one place, or followed along its path. */
const sizes = { fixed: { body: 1, reach: 2.4 }, follow: { body: 0.75, reach: 5 } };
const step = 0.8; // from key to key on the path
const below = 0.72; // the ground, of the size of the body
const square = 0.25; // of the ground, where there are no positions
const opacity = { second: 0.42, key: 0.3 };
const same = 1e-3; // [deg] no eye tells them apart
const near = 1e-3; // length of the scene: no eye tells them apart
const view = { eye: new Vector3(0.62, -1, 0.62).normalize(), points: ball(0.6), share: { width: 0.66, height: 0.66 } };

const pathOf = once((method: Method) => new FlightPath(method, { step }));

export class Body {
  readonly figure: HTMLElement;
  private readonly tip: (text: string | null) => void;
  private readonly stage: Stage;
  private readonly gizmo: Gizmo;
  private readonly forms = new Shapes();
  private readonly ground = new Ground();
  private readonly floor = new Group(); // the ground, level in a world of another up
  private readonly way = new Trail({ width: 2.5, order: 2 });
  private readonly neighbours: Neighbours;
  private readonly swatches = { first: element('span'), second: element('span') };
  private bodies!: Record<'first' | 'second' | 'key', Bodies>;
  private turn?: TurnByHand;
  private path?: FlightPath;

  constructor(
    private readonly studio: Studio,
    painter: Painter,
  ) {
    const { store, view: looked } = studio;
    const [shape, shapeSelect] = menu('Shape', shapes, (name) => looked.choose({ body: name as BodyShape }));
    const [space] = menu('Rings', spaces, (name) => this.gizmo.setSpace(name as Space));
    const [up, upSelect] = menu('Up', ups, (axis) => looked.choose({ up: axis as Up }));
    const { figure, frame, stage, tip } = figureWith(studio, painter, 'Body', [...Object.values(this.swatches), space, up, shape]);
    this.figure = figure;
    this.tip = tip;
    this.stage = stage;
    this.gizmo = new Gizmo(stage, frame, { begin: () => this.begin(), turn: (by) => this.turn?.turn(by), end: () => this.end() });
    this.neighbours = new Neighbours(stage, (key) => this.place(key));
    this.floor.add(this.ground.object);
    stage.scene.add(this.floor, this.way.object, this.neighbours.object);
    stage.scene.onBeforeRender = () => this.neighbours.arrange();
    this.hear();
    looked.watchSize(frame, () => this.gizmo.fit());
    looked.atEnd(() => this.gizmo.dispose());
    looked.subscribe(['up'], (state) => {
      upSelect.value = state.up;
      this.stand(state);
    });
    looked.subscribe(['body'], (state) => {
      shapeSelect.value = state.body;
      this.reshape(state);
    });
    looked.subscribe(['first', 'second'], (state) => this.layPath(state));
    looked.subscribe(['body', 'theme', 'first', 'second'], (state) => this.paint(state));
    looked.subscribe(['body', 'theme', 'first', 'second', 'time', 'playing', 'up'], () => this.show());
    looked.atEnd(store.subscribe(['document', 'chosen'], () => this.show()));
  }

  private reshape({ body }: ViewState): void {
    for (const before of Object.values(this.bodies ?? {})) {
      before.object.removeFromParent();
      before.dispose();
    }
    const parts = this.forms.of(body);
    const withAxes = body === 'aircraft' ? [...parts, ...this.forms.of('axes').filter(({ paint }) => typeof paint !== 'number')] : parts;
    const plain = parts.filter(({ isDetail }) => !isDetail);
    this.bodies = { first: new Bodies(withAxes, 1, true), second: new Bodies(plain, 1, false), key: new Bodies(plain, 1, false) };
    this.stage.scene.add(...Object.values(this.bodies).map(({ object }) => object));
    this.neighbours.reshape(parts);
  }

  private stand({ up }: ViewState): void {
    const turn = standing[up];
    this.floor.quaternion.copy(turn);
    this.stage.stand(vertical(up));
    this.stage.lookAt({ ...view, eye: view.eye.clone().applyQuaternion(turn) });
  }

  private layPath({ first }: ViewState): void {
    const method = this.studio.view.methodNamed(first);
    this.path = method && hasPositions(method) ? pathOf(method) : undefined;
    const { body, reach } = this.size;
    const side = this.path ? roundStep((0.7 * body) / this.path.unit) * this.path.unit : square;
    this.ground.set({ height: -below * body, square: side, reach });
    this.way.set(this.path?.line ?? new Float32Array());
  }

  private paint(state: ViewState): void {
    const colours = this.studio.view.colours(state);
    this.bodies.first.paint(colours.first, colours);
    this.bodies.second.paint(colours.second, colours, opacity.second);
    this.bodies.key.paint(colours.faint, colours, opacity.key);
    this.neighbours.paint(colours);
    this.gizmo.paint(colours);
    this.ground.paint(colours);
    this.way.paint(colours.first, colours);
    for (const [which, swatch] of Object.entries(this.swatches) as ['first' | 'second', HTMLElement][]) {
      const name = state[which];
      swatch.hidden = name === null;
      const line = element('i');
      line.style.background = colours[which];
      swatch.replaceChildren(line, name ?? '');
    }
  }

  private get size() {
    return this.path ? sizes.follow : sizes.fixed;
  }

  /** Where a key is in the scene, in whose middle the body is now. */
  private place({ p }: Key): Vector3 {
    const here = new Vector3();
    if (!this.path || !p) return here;
    return this.path.at(new Vector3(...p)).sub(this.path.atTime(this.studio.view.current().time));
  }

  /** Where the other body is, which may have a path of its own. */
  private get besideFirst(): Vector3 {
    const { current, methodNamed } = this.studio.view;
    const { time, second } = current();
    const samples = methodNamed(second)?.samples;
    if (!this.path || !samples || samples.p.length === 0) return new Vector3();
    return this.path.at(new Vector3(...vectorAt(samples.t, samples.p, time))).sub(this.path.atTime(time));
  }

  /** Of a method now; at the time of the chosen key, that of the key, for its curve comes later. */
  private orientationOf(which: 'first' | 'second', key: Key | undefined): Quaternion | null {
    const { current, methodNamed } = this.studio.view;
    const { time, [which]: name } = current();
    if (which === 'first' && key?.t === time) return key.q;
    const method = methodNamed(name);
    return method && isShownAt(method.samples, time) ? orientationAt(method.samples, time) : null;
  }

  private show(): void {
    const { store, view: looked } = this.studio;
    const { document, chosen } = store.current();
    const { time, playing } = looked.current();
    const key = keyWith(document, chosen);
    const isAtKey = key?.t === time;
    const [first, second] = [this.orientationOf('first', key), this.orientationOf('second', key)];
    const [at, beside] = [key ? this.place(key) : new Vector3(), this.besideFirst];
    const isOther = second !== null && !isAtKey && (first === null || beside.length() > near || angleBetween([...first], [...second]) > same);
    this.put('first', first);
    this.put('second', isOther ? second : null, beside);
    this.put('key', key && !isAtKey && !playing ? key.q : null, at);
    this.gizmo.show(key && !playing ? { q: key.q, at } : null);
    const here = this.path?.atTime(time) ?? new Vector3();
    this.way.object.position.copy(here).negate();
    this.ground.shift(here.clone().applyQuaternion(standing[looked.current().up].clone().invert()));
    this.ground.shade(new Vector3(), first ? 0.6 * this.size.body : 0);
    this.neighbours.show(keysBeside(document.keys, key, time), document.keys, this.path !== undefined);
    this.stage.draw();
  }

  private put(which: 'first' | 'second' | 'key', q: Quaternion | null, at = new Vector3()): void {
    const body = this.bodies[which];
    body.object.visible = q !== null;
    if (q) body.place(0, [...q], this.size.body, at);
  }

  private begin(): void {
    const { document, chosen } = this.studio.store.current();
    const key = keyWith(document, chosen);
    if (key) this.turn = new TurnByHand(this.studio, key);
    this.tip(this.gizmo.meaning);
  }

  private end(): void {
    this.turn = undefined;
    this.tip(null);
  }

  /** A click on a neighbour chooses it. */
  private hear(): void {
    const { canvas } = this.stage;
    let pressed: PointerEvent | null = null;
    canvas.addEventListener('pointerdown', (event) => (pressed = event.isPrimary && event.button === 0 && !this.gizmo.isUnderPointer ? event : null));
    canvas.addEventListener('pointerup', (event) => {
      const isClick = pressed && Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) < 4;
      pressed = null;
      const key = isClick && this.neighbours.under(event);
      if (key) this.studio.store.choose(key.id);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) this.tip(this.gizmo.meaning);
      if (event.buttons === 0) canvas.style.cursor = this.gizmo.isUnderPointer ? 'grab' : this.neighbours.under(event) ? 'pointer' : '';
    });
    canvas.addEventListener('keydown', ({ key }) => {
      if (key !== 'Escape' || !this.turn) return;
      this.turn.giveUp();
      this.gizmo.letGo();
    });
  }
}
