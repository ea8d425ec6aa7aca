// SPDX-License-Identifier: Apache-2.0
// The way of a body axis over the unit sphere, for both methods, the reference and the keys.
import { element } from '../look/element';
import { coloursOf } from '../look/theme';
import { isShownAt, orientationAt, ownTime } from '../motion/orientation';
import { bodyAxis } from '../motion/quaternion';
import type { State, Store } from '../store/store';
import { directionsOf, Dots, Globe, globeOutline, nameAxes, Pointer, wayOnSphere, waysOf } from './globe';
import type { Painter } from './painter';
import { Stage } from './stage';
import { eyeBefore } from './view';

const chosenPlaces = ['second', 'first'] as const;

export class SphereScene {
  readonly figure: HTMLElement;
  private readonly caption = element('strong');
  private readonly stage: Stage;
  private readonly globe = new Globe();
  private readonly dots = new Dots(0.022, 5);
  private readonly marks = new Dots(0.034, 6);
  private readonly reference = wayOnSphere(5, 1);
  private readonly ways = { second: wayOnSphere(2.5, 2), first: wayOnSphere(3, 4) };
  private readonly pointers = { second: new Pointer(), first: new Pointer() };

  constructor(
    private readonly store: Store,
    painter: Painter,
  ) {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: 'sphere' }, element('figcaption', {}, this.caption), frame);
    this.stage = new Stage(store, painter, frame);
    nameAxes(this.stage.overlay);
    const { scene } = this.stage;
    for (const part of [this.globe, this.dots, this.marks, this.reference, ...Object.values(this.ways), ...Object.values(this.pointers)]) scene.add(part.object);
    const { subscribe } = store;
    subscribe(['axis'], (state) => this.turnTo(state));
    for (const which of chosenPlaces) subscribe([which, 'axis'], (state) => this.showMethod(state, which));
    subscribe(['theme'], (state) => this.paint(state));
    subscribe(['first', 'second', 'axis', 'theme', 'time'], (state) => this.showTime(state));
  }

  /** Shows the ways of another axis. */
  private turnTo({ axis, first }: State): void {
    const { report, methodNamed } = this.store;
    this.caption.textContent = `Body axis ${axis} on the unit sphere`;
    this.stage.describe(this.caption.textContent);
    if (report.reference) this.reference.set(waysOf[axis](report.reference));
    if (report.marks) this.marks.set(report.marks, axis);
    this.marks.object.visible = report.marks !== null;
    this.stage.lookAt({ eye: eyeBefore(directionsOf(methodNamed(first)?.samples ?? report.keys, axis)), points: globeOutline });
  }

  private showMethod(state: State, which: (typeof chosenPlaces)[number]): void {
    const { methodNamed, keysOf } = this.store;
    const method = methodNamed(state[which]);
    this.ways[which].set(method ? waysOf[state.axis](method.samples) : new Float32Array());
    if (which === 'first') this.dots.set(keysOf(method), state.axis);
  }

  private paint(state: State): void {
    const colours = coloursOf(state);
    this.globe.paint(colours);
    this.dots.paint(colours.ink);
    this.marks.paint(colours.mark);
    this.reference.paint(colours.reference, colours);
    for (const which of chosenPlaces) {
      this.ways[which].paint(colours[which], colours);
      this.pointers[which].paint(colours[which], colours);
    }
  }

  private showTime(state: State): void {
    for (const which of chosenPlaces) {
      const method = this.store.methodNamed(state[which]);
      const own = method && ownTime(method.clock, state.time);
      const isShown = method !== undefined && isShownAt(method.samples, own!);
      this.pointers[which].object.visible = isShown;
      if (isShown) this.pointers[which].turnTo(bodyAxis(orientationAt(method.samples, own!), state.axis));
    }
    this.stage.draw();
  }
}
