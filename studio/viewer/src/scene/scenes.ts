// SPDX-License-Identifier: Apache-2.0
// The scenes side by side, and how they are to be seen.
import type { BodyShape } from '../data/report';
import { element, menu } from '../look/element';
import type { Axis } from '../motion/quaternion';
import type { State, Store } from '../store/store';
import { MotionScene } from './motionScene';
import { painterOf, type Painter } from './painter';
import { Shapes } from './shapes';
import { SphereScene } from './sphereScene';

const bodies: [BodyShape, string][] = [
  ['box', 'box'],
  ['axes', 'axes'],
  ['aircraft', 'aircraft'],
];
const axes: [Axis, string][] = [
  ['x', 'x'],
  ['y', 'y'],
  ['z', 'z'],
];
const places: [State['place'], string][] = [
  ['follow', 'near by, on its path'],
  ['path', 'with the whole path'],
  ['fixed', 'in one place'],
];

function controls({ choose, subscribe, canFollowPath }: Store): HTMLElement {
  const [bodyChoice, bodySelect] = menu('Body', bodies, (shape) => choose({ body: shape as BodyShape }));
  const [placeChoice, placeSelect] = menu('Seen', places, (where) => choose({ place: where as State['place'] }));
  const [axisChoice, axisSelect] = menu('Axis on sphere', axes, (axis) => choose({ axis: axis as Axis }));
  subscribe(['body', 'place', 'axis'], (state) => {
    bodySelect.value = state.body;
    placeSelect.value = state.place;
    axisSelect.value = state.axis;
  });
  return element('div', { className: 'controls' }, bodyChoice, axisChoice, ...(canFollowPath ? [placeChoice] : []));
}

/** What is shown where the browser cannot draw in space. */
const noScenes = () => element('p', { className: 'facts' }, 'The scenes in space are not shown: this browser has no WebGL. The tables and the plots are complete.');

/** What the scenes show, or a sentence instead of them. */
export function withPainter(store: Store, show: (painter: Painter) => HTMLElement[]): HTMLElement[] {
  const painter = painterOf(store);
  return painter ? show(painter) : [noScenes()];
}

export const scenesOf = (store: Store): HTMLElement[] =>
  withPainter(store, (painter) => {
    const shapes = new Shapes();
    const [first, second] = [new MotionScene(store, painter, shapes, 'first'), new MotionScene(store, painter, shapes, 'second')];
    first.linkCamera(second);
    return [controls(store), element('div', { className: 'stages' }, first.figure, second.figure, new SphereScene(store, painter).figure)];
  });
