// SPDX-License-Identifier: Apache-2.0
// The ways of a body axis over the unit sphere under both curves. Its keys are handles: a pull turns the key so that its axis is under the pointer.
import type { Vector3 } from 'three';
import type { Path } from 'orispline-viewer/data/report';
import { menu } from 'orispline-viewer/look/element';
import { isShownAt, orientationAt } from 'orispline-viewer/motion/orientation';
import { bodyAxis, type Axis } from 'orispline-viewer/motion/quaternion';
import { directionsOf, Globe, globeOutline, lift, nameAxes, Pointer, wayOnSphere, waysOf } from 'orispline-viewer/scene/globe';
import type { Painter } from 'orispline-viewer/scene/painter';
import type { Place, Stage } from 'orispline-viewer/scene/stage';
import { eyeBefore, standing, vertical } from 'orispline-viewer/scene/view';
import type { State as ViewState } from 'orispline-viewer/store/store';
import { keyWith, type Key } from '../document/document';
import type { Studio } from '../store/studio';
import { TurnByHand } from './edit';
import { figureWith } from './figure';
import { Handles } from './handles';
import { directionUnder, turnBetween } from './pull';

const both = ['second', 'first'] as const;
const still = 3; // [px] what moves less is a click
const axes: [Axis, string][] = [['x', 'x'], ['y', 'y'], ['z', 'z']];

const pathOf = (keys: readonly Key[]): Path => ({ t: Float64Array.from(keys, ({ t }) => t), q: Float64Array.from(keys.flatMap(({ q }) => q)) });

interface Pull {
  turn: TurnByHand | null; // none until the pointer has moved
  key: Key;
  from: Vector3; // where the axis pointed
  isBehind: boolean;
  place: Place;
}

export class Sphere {
  readonly figure: HTMLElement;
  private readonly tip: (text: string | null) => void;
  private readonly stage: Stage;
  private readonly globe = new Globe();
  private readonly ways = { second: wayOnSphere(2.5, 2), first: wayOnSphere(3, 4) };
  private readonly pointers = { second: new Pointer(), first: new Pointer() };
  private readonly handles: Handles;
  private pull?: Pull;

  constructor(
    private readonly studio: Studio,
    painter: Painter,
  ) {
    const { store, view } = studio;
    const [choice, select] = menu('Body axis', axes, (axis) => view.choose({ axis: axis as Axis }));
    const { figure, frame, stage, tip } = figureWith(studio, painter, 'Sphere', [choice]);
    this.figure = figure;
    this.tip = tip;
    this.stage = stage;
    this.handles = new Handles(stage, frame);
    stage.scene.onBeforeRender = () => this.handles.arrange();
    nameAxes(stage.overlay);
    for (const part of [this.globe, ...Object.values(this.ways), ...Object.values(this.pointers)]) stage.scene.add(part.object);
    this.hear(frame);
    const { subscribe } = view;
    subscribe(['up'], ({ up }) => {
      this.globe.stand(standing[up]);
      stage.stand(vertical(up));
    });
    subscribe(['axis', 'up'], (state) => {
      select.value = state.axis;
      this.look(state);
    });
    for (const which of both) subscribe([which, 'axis'], (state) => this.showWay(state, which));
    subscribe(['theme', 'first', 'second'], (state) => this.paint(state));
    subscribe(['axis'], () => this.showKeys());
    view.atEnd(store.subscribe(['document', 'chosen'], () => this.showKeys()));
    subscribe(['first', 'second', 'axis', 'theme', 'time'], (state) => this.showTime(state));
  }

  /** From where most of the keys are before the sphere, a little from above. */
  private look({ axis, up }: ViewState): void {
    const turn = standing[up];
    const back = turn.clone().invert();
    const directions = directionsOf(pathOf(this.studio.store.current().document.keys), axis).map((direction) => direction.applyQuaternion(back));
    this.stage.lookAt({ eye: eyeBefore(directions).applyQuaternion(turn), points: globeOutline });
  }

  private paint(state: ViewState): void {
    const colours = this.studio.view.colours(state);
    this.globe.paint(colours);
    for (const which of both) {
      this.ways[which].paint(colours[which], colours);
      this.pointers[which].paint(colours[which], colours);
    }
  }

  private showWay(state: ViewState, which: (typeof both)[number]): void {
    const method = this.studio.view.methodNamed(state[which]);
    this.ways[which].set(method ? waysOf[state.axis](method.samples) : new Float32Array());
  }

  private showKeys(): void {
    const { store, view } = this.studio;
    const { document, chosen } = store.current();
    this.handles.set(document.keys, chosen, view.current().axis);
    this.showTime(view.current());
  }

  /** At the time of the chosen key, the first one is where the key is, before its curve is. */
  private showTime(state: ViewState): void {
    const { store, view } = this.studio;
    const { document, chosen } = store.current();
    const key = keyWith(document, chosen);
    for (const which of both) {
      const method = view.methodNamed(state[which]);
      const isShown = method !== undefined && isShownAt(method.samples, state.time);
      this.pointers[which].object.visible = isShown;
      if (isShown) this.pointers[which].turnTo(bodyAxis(key?.t === state.time ? [...key.q] : orientationAt(method.samples, state.time), state.axis));
    }
    this.stage.draw();
  }

  private hear(frame: HTMLElement): void {
    const { canvas } = this.stage;
    frame.addEventListener('pointerdown', (event) => this.begin(event), { capture: true });
    canvas.addEventListener('touchstart', (event) => this.pull && event.preventDefault(), { passive: false }); // else the page moves
    canvas.addEventListener('pointermove', (event) => this.follow(event));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) canvas.addEventListener(name, (event) => event.isPrimary && this.end());
    canvas.addEventListener('keydown', ({ key }) => key === 'Escape' && this.giveUp());
  }

  private begin(event: PointerEvent): void {
    if (!event.isPrimary || event.button !== 0) return;
    const { canvas, controls } = this.stage;
    const key = this.handles.under(event);
    controls.enabled = key === null; // what is empty turns the camera
    if (!key) return;
    const from = this.handles.directionOf(key)!;
    this.pull = { turn: null, key, from, isBehind: this.handles.isBehind(from), place: event };
    canvas.setPointerCapture(event.pointerId);
    this.tip(this.meaning);
    this.studio.store.choose(key.id);
  }

  private follow(event: PointerEvent): void {
    const { canvas } = this.stage;
    const { pull } = this;
    if (!pull) {
      if (event.buttons !== 0) return;
      const under = this.handles.under(event);
      canvas.style.cursor = under ? 'grab' : '';
      this.tip(under && this.meaning);
      return;
    }
    if (!event.isPrimary) return;
    if (!pull.turn && Math.hypot(event.clientX - pull.place.clientX, event.clientY - pull.place.clientY) < still) return;
    canvas.style.cursor = 'grabbing';
    pull.turn ??= new TurnByHand(this.studio, pull.key);
    pull.turn.turn(turnBetween(pull.from, directionUnder(this.stage.rayThrough(event), lift, pull.isBehind)));
  }

  private get meaning(): string {
    return `Pull: turns the key so that the ${this.studio.view.current().axis} axis of its body points there.`;
  }

  private end(): void {
    this.pull = undefined;
    this.tip(null);
    this.stage.controls.enabled = true;
    this.stage.canvas.style.cursor = '';
  }

  private giveUp(): void {
    this.pull?.turn?.giveUp();
    this.end();
  }
}
