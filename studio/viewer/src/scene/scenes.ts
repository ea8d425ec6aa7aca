// SPDX-License-Identifier: Apache-2.0
// The scenes side by side, and how they are to be seen.
import type { BodyShape } from '../data/report';
import { element, menu } from '../look/element';
import type { Axis } from '../motion/quaternion';
import type { State, Store } from '../store/store';
import { MotionScene } from './motionScene';
import { SphereScene } from './sphereScene';

const shapes: [BodyShape, string][] = [
  ['aircraft', 'aircraft'],
  ['box', 'box'],
  ['axes', 'axes'],
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
  const [bodyChoice, bodySelect] = menu('Body', shapes, (shape) => choose({ body: shape as BodyShape }));
  const [placeChoice, placeSelect] = menu('Seen', places, (where) => choose({ place: where as State['place'] }));
  const [axisChoice, axisSelect] = menu('Axis on the sphere', axes, (axis) => choose({ axis: axis as Axis }));
  subscribe(['body', 'place', 'axis'], (state) => {
    bodySelect.value = state.body;
    placeSelect.value = state.place;
    axisSelect.value = state.axis;
  });
  return element('div', { className: 'controls' }, bodyChoice, ...(canFollowPath ? [placeChoice] : []), axisChoice);
}

export function canDraw(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext(); // a browser has few
  return context !== null;
}

/** What is shown where the browser cannot draw in space. */
export const noScenes = () => element('p', { className: 'facts' }, 'The scenes in space are not shown: this browser has no WebGL.');

export function scenesOf(store: Store): HTMLElement[] {
  if (!canDraw()) return [noScenes()];
  const [first, second] = [new MotionScene(store, 'first'), new MotionScene(store, 'second')];
  first.linkCamera(second);
  return [controls(store), element('div', { className: 'stages' }, first.figure, second.figure, new SphereScene(store).figure)];
}
