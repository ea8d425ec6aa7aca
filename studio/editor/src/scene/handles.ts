// SPDX-License-Identifier: Apache-2.0
// Keys on the sphere, to be pulled: as large from every side, fainter behind.
import { Vector3 } from 'three';
import { bodyAxis, type Axis } from 'orispline-viewer/motion/quaternion';
import { lift } from 'orispline-viewer/scene/globe';
import type { Place, Stage } from 'orispline-viewer/scene/stage';
import type { Key } from '../document/document';

const reach = { mouse: 12, touch: 22 }; // [px] of a handle

interface Handle {
  key: Key;
  direction: Vector3;
}

const circle = (className: string) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
  made.setAttribute('class', className);
  return made;
};

export class Handles {
  private readonly svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  private readonly circles: SVGCircleElement[] = [];
  private readonly ring = circle('ring');
  private handles: Handle[] = [];
  private chosen: number | null = null;

  constructor(
    private readonly stage: Stage,
    frame: HTMLElement,
  ) {
    this.svg.setAttribute('aria-hidden', 'true');
    this.svg.append(this.ring);
    frame.append(this.svg);
  }

  set(keys: readonly Key[], chosen: number | null, axis: Axis): void {
    this.chosen = chosen;
    this.handles = keys.map((key) => ({ key, direction: new Vector3(...bodyAxis([...key.q], axis)) }));
    while (this.circles.length < keys.length) {
      this.circles.push(circle('handle'));
      this.svg.append(this.circles.at(-1)!);
    }
    for (const left of this.circles.splice(keys.length)) left.remove();
  }

  directionOf(key: Key): Vector3 | undefined {
    return this.handles.find((handle) => handle.key.id === key.id)?.direction;
  }

  isBehind = (direction: Vector3): boolean => direction.dot(this.stage.camera.position) < lift;

  private get places(): Place[] {
    return this.stage.placesOf(this.handles.map(({ direction }) => direction.clone().multiplyScalar(lift)));
  }

  /** As the camera is. All is measured before anything is moved, else the browser lays the page out for each. */
  arrange(): void {
    const { left, top } = this.svg.getBoundingClientRect();
    const { places } = this;
    this.ring.setAttribute('visibility', 'hidden');
    this.handles.forEach((handle, i) => {
      const { clientX, clientY } = places[i];
      const isBehind = this.isBehind(handle.direction);
      const put = (one: SVGCircleElement, name: string) => {
        one.setAttribute('class', isBehind ? `${name} behind` : name);
        one.setAttribute('cx', (clientX - left).toFixed(2));
        one.setAttribute('cy', (clientY - top).toFixed(2));
      };
      put(this.circles[i], 'handle');
      if (handle.key.id !== this.chosen) return;
      this.ring.removeAttribute('visibility');
      put(this.ring, 'ring');
    });
  }

  /** The key at a place: the nearest one in front, else behind; the chosen one rather than another. */
  under(event: PointerEvent): Key | null {
    const most = event.pointerType === 'touch' ? reach.touch : reach.mouse;
    let [best, least]: [Key | null, number] = [null, Infinity];
    const { places } = this;
    for (const [i, handle] of this.handles.entries()) {
      const { clientX, clientY } = places[i];
      const off = Math.hypot(clientX - event.clientX, clientY - event.clientY);
      if (off > most) continue;
      const rank = off + (this.isBehind(handle.direction) ? 2 * most : 0) - (handle.key.id === this.chosen ? most : 0);
      if (rank < least) [best, least] = [handle.key, rank];
    }
    return best;
  }
}
