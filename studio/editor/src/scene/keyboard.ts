// SPDX-License-Identifier: Apache-2.0
// The chosen key, turned from the keyboard about the axes of the screen, and the eye, moved around it.
import { Vector3 } from 'three';
import type { Stage } from 'orispline-viewer/scene/stage';
import type { StudioDocument } from '../document/document';
import { turnedInWorld } from '../edits/turn';
import type { Studio } from '../store/studio';

const [toTheRight, upwards, towardsTheEye] = [0, 1, 2]; // axes of the camera
const turns: Record<string, [axis: number, sense: number]> = {
  ArrowUp: [toTheRight, -1],
  ArrowDown: [toTheRight, 1],
  ArrowLeft: [upwards, -1],
  ArrowRight: [upwards, 1],
  PageUp: [towardsTheEye, 1],
  PageDown: [towardsTheEye, -1],
};
const pause = 1000; // [ms] after which a key that is pressed again begins another step of the history

const degrees = ({ ctrlKey, shiftKey }: KeyboardEvent) => (ctrlKey ? 0.1 : shiftKey ? 10 : 1);

/** Turns the chosen key while the canvas has the focus; `turned` is called after each turn. */
export function hearTurns({ store, view }: Studio, { canvas, camera }: Stage, turned: () => void): void {
  let gesture = {};
  let last = { time: -Infinity, id: -1, document: null as StudioDocument | null };
  canvas.addEventListener('keydown', (event) => {
    const { document, chosen } = store.current();
    const key = document.keys.find(({ id }) => id === chosen);
    if (!key || !(event.key in turns) || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation(); // elsewhere arrows step the time
    const goesOn = (event.repeat || event.timeStamp - last.time < pause) && last.id === key.id && last.document === document;
    if (!goesOn) gesture = {};
    view.choose({ time: key.t, playing: false });
    const [axis, sense] = turns[event.key];
    camera.updateMatrixWorld();
    const by = new Vector3().setFromMatrixColumn(camera.matrixWorld, axis).normalize().multiplyScalar((sense * degrees(event) * Math.PI) / 180);
    store.edit(turnedInWorld(document, key.id, by.toArray()), gesture);
    last = { time: event.timeStamp, id: key.id, document: store.current().document };
    turned();
  });
}

const looks: Record<string, [aside: number, upwards: number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const look = (5 * Math.PI) / 180;

/** Alt with arrows moves the eye to where they point, as a drag of what is empty does. */
export function hearLooks(stage: Stage): void {
  stage.canvas.addEventListener('keydown', (event) => {
    if (!event.altKey || event.ctrlKey || event.metaKey || !(event.key in looks)) return;
    event.preventDefault(); // a browser may go back in its history
    event.stopPropagation();
    const [aside, upwards] = looks[event.key];
    stage.orbit(aside * look, upwards * look);
  });
}
