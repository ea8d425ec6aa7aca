// SPDX-License-Identifier: Apache-2.0
// The scenes side by side, and how they are to be seen.
import { element, menu, place } from '../element';
import { report, type BodyShape } from '../report';
import { canFollowPath, choose, subscribe, type State } from '../state';
import type { Axis } from '../motion';
import { MotionScene } from './motionScene';
import { SphereScene } from './sphereScene';

const manyMethods = 6; // a table so long stands beside the scenes, where there is room

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

function controls(): HTMLElement {
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

/** Says so where it cannot. */
export function canDraw(): boolean {
  const can = document.createElement('canvas').getContext('webgl2') !== null;
  if (!can) place('scenes').append(element('p', { className: 'facts' }, 'The scenes in space are not shown: this browser has no WebGL.'));
  return can;
}

export function showScenes(): void {
  if (!canDraw()) return;
  place('scenes').parentElement!.classList.toggle('beside', report.methods.length >= manyMethods);
  const [first, second] = [new MotionScene('first'), new MotionScene('second')];
  first.linkCamera(second);
  place('scenes').append(controls(), element('div', { className: 'stages' }, first.figure, second.figure, new SphereScene().figure));
}
