// SPDX-License-Identifier: Apache-2.0
// A canvas with a camera that the user turns; drawn when something has changed, not all the time.
import { DirectionalLight, HemisphereLight, PerspectiveCamera, Raycaster, Scene, Vector2, type Object3D, type Ray, type Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { element } from '../look/element';
import { coloursOf } from '../look/theme';
import type { Store } from '../store/store';
import { Overlay, zUp, type WorldAxes } from './overlay';
import type { Painter, Size } from './painter';
import { placeOf as placeOfCamera, type View } from './view';

/** On the page [px], as events of a pointer have it. */
export interface Place {
  clientX: number;
  clientY: number;
}

const closest = 0.02; // [rad] of the eye to the vertical

const lost = 'The browser has taken the graphics away. The scene goes on when they are back.';

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(32, 1, 0.1, 100);
  controls: OrbitControls;
  readonly overlay: Overlay;
  readonly canvas = element('canvas', { attributes: { role: 'img' } });
  private readonly sky = new HemisphereLight(0xffffff, 0x8c8c94, 1.75);
  private readonly size: Size = { width: 0, height: 0 };
  private view?: View; // until the user turns the camera

  constructor(
    store: Store,
    private readonly painter: Painter,
    frame: HTMLElement,
    world: WorldAxes = zUp,
  ) {
    const sentence = element('p', { className: 'lost', hidden: true, attributes: { role: 'status' } }, lost);
    frame.append(this.canvas, sentence);
    this.overlay = new Overlay(frame, world);
    this.camera.up.set(0, 0, 1);
    this.controls = this.controlled();
    this.light();
    store.subscribe(['theme'], (state) => this.overlay.paint(coloursOf(state)));
    store.watchSize(frame, () => this.fit(frame));
    store.atEnd(() => this.end());
    painter.watch((isLost) => {
      sentence.hidden = !isLost;
      this.draw();
    });
  }

  private controlled(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enablePan = false;
    controls.addEventListener('change', () => this.draw());
    controls.addEventListener('start', () => (this.view = undefined));
    return controls;
  }

  /** Which way is up; what is seen is chosen anew then. */
  stand(up: Vector3): void {
    this.camera.up.copy(up);
    this.sky.position.copy(up);
    this.controls.dispose();
    this.controls = this.controlled(); // these know but the way that was up when they were made
  }

  /** From the sky and from the ground, and from where the user looks: no side is black. */
  private light(): void {
    const [key, fill] = [new DirectionalLight(0xffffff, 1.5), new DirectionalLight(0xffffff, 0.55)];
    key.position.set(-0.5, 0.9, 0.7); // from the eye: up to the left
    fill.position.set(0.9, -0.1, 0.5);
    this.camera.add(key, key.target, fill, fill.target);
    this.sky.position.copy(this.camera.up);
    this.scene.add(this.sky, this.camera);
  }

  /** What is seen, for those who do not see it. */
  describe(text: string): void {
    this.canvas.setAttribute('aria-label', text);
  }

  /** From the eye through a place. */
  rayThrough({ clientX, clientY }: Place): Ray {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height), this.camera);
    return caster.ray;
  }

  /** Where points of the scene are seen. */
  placesOf(points: readonly Vector3[]): Place[] {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    return points.map((point) => {
      const { x, y } = point.clone().project(this.camera);
      return { clientX: left + (width * (1 + x)) / 2, clientY: top + (height * (1 - y)) / 2 };
    });
  }

  placeOf = (point: Vector3): Place => this.placesOf([point])[0];

  /** Soon, once, however often it is asked for. */
  draw(): void {
    this.canvas.setAttribute('aria-busy', 'true');
    this.painter.ask(this.paint);
  }

  private paint = (): void => {
    this.canvas.removeAttribute('aria-busy');
    if (this.size.width === 0) return;
    this.painter.paint(this.scene, this.camera, this.canvas, this.size);
    this.overlay.update(this.camera, this.size);
  };

  /** Turns the camera to where the view is seen best, until the user turns it. */
  lookAt(view: View): void {
    this.view = view;
    this.camera.position.copy(placeOfCamera(view, this.camera));
    this.controls.update();
    this.draw();
  }

  /** Moves the eye around what it looks at [rad], never quite to above or below. */
  orbit(aside: number, upwards: number): void {
    this.view = undefined;
    const { camera, controls } = this;
    const from = camera.position.clone().sub(controls.target);
    const polar = from.angleTo(camera.up);
    const wanted = Math.min(Math.max(polar - upwards, closest), Math.PI - closest);
    from.applyAxisAngle(camera.up.clone().cross(from).normalize(), wanted - polar).applyAxisAngle(camera.up, aside);
    camera.position.copy(controls.target).add(from);
    controls.update();
    this.draw();
  }

  private end(): void {
    release(this.scene);
    this.controls.dispose();
  }

  private fit(frame: HTMLElement): void {
    const { clientWidth: width, clientHeight: height } = frame;
    if (width === 0 || height === 0) return;
    Object.assign(this.size, { width, height });
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.view) this.lookAt(this.view);
    this.draw();
  }
}

/** Frees what the graphics memory holds of an object. */
export function release(object: Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as { geometry?: { dispose(): void }; material?: { dispose(): void } };
    geometry?.dispose();
    material?.dispose();
    (part as { dispose?: () => void }).dispose?.();
  });
}
