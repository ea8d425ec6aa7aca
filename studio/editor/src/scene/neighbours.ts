// SPDX-License-Identifier: Apache-2.0
// The keys before and after the chosen one: where they are on the path, or at both sides of the picture where all are in one place.
import { Group, Vector3 } from 'three';
import type { Colours } from 'orispline-viewer/look/theme';
import { Bodies } from 'orispline-viewer/scene/bodies';
import type { Part } from 'orispline-viewer/scene/shapes';
import type { Place, Stage } from 'orispline-viewer/scene/stage';
import type { Key } from '../document/document';

type Pair = readonly [before: Key | undefined, after: Key | undefined];

const onPath = 0.6; // size there
const atSide = 0.46; // size there, of half the picture's height
const margin = 0.72; // from the side, in sizes
const nameBelow = { atSide: 0.74, onPath: 0.5 }; // below the middle of a neighbour, in sizes
const opacity = 0.5;
const least = 22; // [px] within which one is hit

/** Those beside a key, else beside a time. */
export function keysBeside(keys: readonly Key[], key: Key | undefined, time: number): Pair {
  const after = key ? keys.indexOf(key) + 1 : keys.findIndex(({ t }) => t > time);
  return after < 0 ? [keys.at(-1), undefined] : [keys[after - (key ? 2 : 1)], keys[after]];
}

interface Shown {
  key: Key;
  at: Vector3;
  size: number;
}

export class Neighbours {
  readonly object = new Group();
  private bodies?: Bodies;
  private keys: Pair = [undefined, undefined];
  private hasPath = false;
  private shown: Shown[] = [];
  private readonly names = [0, 1].map(() => ({ at: new Vector3(), text: null as SVGTextElement | null }));

  constructor(
    private readonly stage: Stage,
    private readonly placeOf: (key: Key) => Vector3,
  ) {
    for (const name of this.names) name.text = stage.overlay.name('', name.at, false);
  }

  reshape(parts: Part[]): void {
    this.bodies?.object.removeFromParent();
    this.bodies?.dispose();
    this.bodies = new Bodies(parts, 2, true);
    this.object.add(this.bodies.object);
    this.bodies.show(0);
  }

  paint(colours: Colours): void {
    this.bodies!.paint(colours.faint, colours, opacity);
  }

  show(keys: Pair, all: readonly Key[], hasPath: boolean): void {
    this.keys = keys;
    this.hasPath = hasPath;
    keys.forEach((key, side) => {
      const text = key ? `key ${all.indexOf(key) + 1}` : '';
      if (this.names[side].text!.textContent !== text) this.names[side].text!.textContent = text;
    });
  }

  /** As the camera is when they are drawn. */
  arrange(): void {
    const { camera } = this.stage;
    const high = camera.position.length() * Math.tan((camera.fov * Math.PI) / 360); // half the picture, at its middle
    const wide = high * camera.aspect;
    const size = this.hasPath ? onPath : atSide * Math.min(high, 0.8 * wide);
    const [right, up] = [0, 1].map((column) => new Vector3().setFromMatrixColumn(camera.matrixWorld, column));
    this.shown = [];
    this.keys.forEach((key, side) => {
      if (!key) return;
      const at = this.hasPath ? this.placeOf(key) : right.clone().multiplyScalar((side === 0 ? -1 : 1) * (wide - margin * size));
      this.bodies!.place(this.shown.length, [...key.q], size, at);
      this.names[side].at.copy(at).addScaledVector(up, -(this.hasPath ? nameBelow.onPath : nameBelow.atSide) * size);
      this.shown.push({ key, at, size });
    });
    this.bodies!.show(this.shown.length);
  }

  /** The one at a place, the nearer of both. */
  under(event: Place): Key | null {
    const right = new Vector3().setFromMatrixColumn(this.stage.camera.matrixWorld, 0);
    let [best, off]: [Key | null, number] = [null, Infinity];
    for (const { key, at, size } of this.shown) {
      const [middle, edge] = [this.stage.placeOf(at), this.stage.placeOf(at.clone().addScaledVector(right, size / 2))];
      const distance = Math.hypot(middle.clientX - event.clientX, middle.clientY - event.clientY);
      if (distance < Math.min(off, Math.max(least, Math.abs(edge.clientX - middle.clientX)))) [best, off] = [key, distance];
    }
    return best;
  }
}
