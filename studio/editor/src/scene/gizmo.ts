// SPDX-License-Identifier: Apache-2.0
// Three rings around a body that turn it. They follow the pointer, as large as they are.
import { Object3D, Vector3, type Ray } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Colours } from 'orispline-viewer/look/theme';
import type { Vector } from 'orispline-viewer/motion/quaternion';
import type { Place, Stage } from 'orispline-viewer/scene/stage';
import type { Quaternion } from '../document/document';
import { turnOfRing, type Ring } from './pull';

export type Space = 'world' | 'local';

/** What it tells; the rotation vector is in the world, from where the pull began [rad]. */
export interface Pulls {
  begin: () => void;
  turn: (by: Vector) => void;
  end: () => void;
}

const radius = 0.75; // of its rings, of half the picture
const unit = 0.2375; // that radius at size 1: 1.9 / 4 of the picture's slope, half of it
const axes: Record<string, Vector3> = { X: new Vector3(1, 0, 0), Y: new Vector3(0, 1, 0), Z: new Vector3(0, 0, 1) };

export class Gizmo {
  private readonly handle = new Object3D();
  private readonly controls: TransformControls;
  private pull?: { ring: Ring; from: Ray; angle: number };
  private place: Place = { clientX: 0, clientY: 0 };

  constructor(
    private readonly stage: Stage,
    frame: HTMLElement,
    private readonly pulls: Pulls,
  ) {
    const { canvas, camera, scene } = stage;
    this.controls = new TransformControls(camera, canvas);
    this.controls.setMode('rotate');
    this.controls.showE = false;
    this.controls.showXYZE = false;
    scene.add(this.handle, this.controls.getHelper());
    this.controls.addEventListener('change', () => stage.draw());
    this.controls.addEventListener('mouseDown', () => this.begin());
    this.controls.addEventListener('objectChange', () => this.follow());
    this.controls.addEventListener('mouseUp', () => this.end());
    frame.addEventListener('pointerdown', (event) => this.claim(event), { capture: true });
    frame.addEventListener('pointermove', (event) => (this.place = event), { capture: true });
    canvas.addEventListener('pointercancel', () => this.letGo());
    canvas.addEventListener('touchstart', (event) => this.isPulled && event.preventDefault(), { passive: false }); // else the page moves
    canvas.addEventListener('lostpointercapture', () => (stage.controls.enabled = true));
  }

  get isPulled(): boolean {
    return this.controls.dragging;
  }

  /** The pointer is at one of its rings. */
  get isUnderPointer(): boolean {
    return this.controls.axis !== null;
  }

  /** What a pull at the ring does that is under the pointer, or is pulled; null: there is none. */
  get meaning(): string | null {
    const { axis, space } = this.controls;
    return axis && axis in axes ? `Pull: turns the key about the ${axis.toLowerCase()} axis of the ${space === 'local' ? 'body' : 'world'}.` : null;
  }

  setSpace(space: Space): void {
    this.controls.setSpace(space);
    this.stage.draw();
  }

  paint({ x, y, z, ink }: Colours): void {
    this.controls.setColors(x, y, z, ink);
  }

  /** Around a body; without one it is not there. */
  show(body: { q: Quaternion; at: Vector3 } | null): void {
    if (!body) {
      if (!this.isPulled) this.controls.detach();
      return;
    }
    const [w, x, y, z] = body.q;
    this.handle.position.copy(body.at);
    this.handle.quaternion.set(x, y, z, w);
    this.controls.attach(this.handle);
  }

  /** As large as the picture allows. */
  fit(): void {
    this.controls.setSize((radius / unit) * Math.min(1, this.stage.camera.aspect));
  }

  /** As if the pointer were raised. */
  letGo(): void {
    this.controls.pointerUp(null);
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** Before the camera hears of it, which then does not turn. */
  private claim(event: PointerEvent): void {
    this.place = event;
    if (!event.isPrimary) return;
    const { left, top, width, height } = this.stage.canvas.getBoundingClientRect();
    this.stage.camera.updateMatrixWorld();
    this.controls.pointerHover({ x: (2 * (event.clientX - left)) / width - 1, y: 1 - (2 * (event.clientY - top)) / height, button: event.button } as PointerEvent);
    this.stage.controls.enabled = !this.isUnderPointer;
  }

  private begin(): void {
    const axis = axes[this.controls.axis!].clone();
    const { quaternion, position } = this.handle;
    if (this.controls.space === 'local') axis.applyQuaternion(quaternion);
    const { camera } = this.stage;
    const slope = Math.tan((camera.fov * Math.PI) / 360);
    const ring = { middle: position.clone(), axis, radius: unit * this.controls.size * slope * camera.position.distanceTo(position) };
    this.pull = { ring, from: this.stage.rayThrough(this.place).clone(), angle: 0 };
    this.pulls.begin();
  }

  /** By as much as the ring follows the pointer, over many turns. */
  private follow(): void {
    const { pull } = this;
    if (!pull) return;
    const angle = turnOfRing(pull.ring, pull.from, this.stage.rayThrough(this.place));
    pull.angle = angle + 2 * Math.PI * Math.round((pull.angle - angle) / (2 * Math.PI));
    this.pulls.turn(pull.ring.axis.clone().multiplyScalar(pull.angle).toArray());
  }

  private end(): void {
    this.pull = undefined;
    this.stage.controls.enabled = true;
    this.pulls.end();
  }
}
