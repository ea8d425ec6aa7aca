// SPDX-License-Identifier: Apache-2.0
// Names over a scene, as sharp as all text, and the axes of the world in its corner.
import { Vector3, type PerspectiveCamera } from 'three';
import type { Colours } from '../look/theme';
import type { Axis } from '../motion/quaternion';
import type { Size } from './painter';

const arm = 19; // pixels of the page, as all below
const corner = 34; // from both sides
const beyond = 9; // of a name, from its arm

export const axisNames: Axis[] = ['x', 'y', 'z'];
/** Where the axes of the world point in the scene. */
export type WorldAxes = Record<Axis, Vector3>;
export const zUp: WorldAxes = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };
export const yUp: WorldAxes = { x: new Vector3(1, 0, 0), y: new Vector3(0, 0, 1), z: new Vector3(0, -1, 0) };

function drawn<Tag extends keyof SVGElementTagNameMap>(parent: SVGElement, tag: Tag, attributes: Record<string, string> = {}): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  place(made, attributes);
  parent.append(made);
  return made;
}

function place(what: SVGElement, attributes: Record<string, string | number>): void {
  for (const [name, value] of Object.entries(attributes)) what.setAttribute(name, String(value));
}

function textOf(parent: SVGElement, text: string): SVGTextElement {
  const made = drawn(parent, 'text');
  made.textContent = text;
  return made;
}

interface Name {
  text: SVGTextElement;
  at: Vector3; // in the scene
  hasSphere: boolean;
}

export class Overlay {
  private readonly svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  private readonly arms = drawn(this.svg, 'g');
  private readonly triad: { line: SVGLineElement; text: SVGTextElement; axis: Axis; direction: Vector3 }[];
  private readonly names: Name[] = [];

  constructor(frame: HTMLElement, world: WorldAxes) {
    this.svg.setAttribute('aria-hidden', 'true');
    this.triad = axisNames.map((axis) => ({ line: drawn(this.arms, 'line'), text: textOf(this.arms, axis), axis, direction: world[axis] }));
    frame.append(this.svg);
  }

  /** A name at a place of the scene, which may move; fainter where the unit sphere is before it, if there is one. */
  name(text: string, at: Vector3, hasSphere = true): SVGTextElement {
    const made = textOf(this.svg, text);
    this.names.push({ text: made, at, hasSphere });
    return made;
  }

  paint(colours: Colours): void {
    for (const { line, axis } of this.triad) line.setAttribute('stroke', colours[axis]);
  }

  update(camera: PerspectiveCamera, { width, height }: Size): void {
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const seen = this.triad.map((one) => ({ ...one, towards: one.direction.clone().transformDirection(camera.matrixWorldInverse) }));
    for (const { line, text, towards } of seen.sort((a, b) => a.towards.z - b.towards.z)) {
      const end = (length: number) => ({ x: corner + length * towards.x, y: height - corner - length * towards.y });
      const [tip, label] = [end(arm), end(arm + beyond)];
      place(line, { x1: corner, y1: height - corner, x2: tip.x, y2: tip.y });
      place(text, label);
      this.arms.append(line, text); // what points to the eye is drawn last
    }
    for (const { text, at, hasSphere } of this.names) {
      const { x, y } = at.clone().project(camera);
      place(text, { x: (width * (1 + x)) / 2, y: (height * (1 - y)) / 2, class: hasSphere && isBehindBall(at, camera.position) ? 'behind' : '' });
    }
  }
}

function isBehindBall(at: Vector3, eye: Vector3): boolean {
  const way = at.clone().sub(eye);
  const along = -eye.dot(way) / way.lengthSq();
  return along > 0 && along < 1 && eye.clone().addScaledVector(way, along).lengthSq() < 1;
}
