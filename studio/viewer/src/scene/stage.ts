// SPDX-License-Identifier: Apache-2.0
// A canvas with a camera that the user turns; drawn when something has changed, not all the time.
import { AmbientLight, DirectionalLight, PerspectiveCamera, Scene, WebGLRenderer, type Object3D, type Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Store } from '../store/store';
import { viewFrom, viewOf } from './view';

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(35, 1, 0.1, 100);
  readonly controls: OrbitControls;
  private readonly renderer = new WebGLRenderer({ antialias: true, alpha: true });
  private awaited = false;
  private ended = false;
  private seen: Vector3[] = []; // until the user turns the camera
  private eye?: Vector3;

  constructor(store: Store, frame: HTMLElement) {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.domElement.setAttribute('role', 'img');
    frame.append(this.renderer.domElement);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enablePan = false;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => (this.seen = []));
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(-1, -2, 4);
    this.scene.add(new AmbientLight(0xffffff, 1.6), sun);
    store.watchSize(frame, () => this.fit(frame));
    store.atEnd(() => this.end());
  }

  /** What is seen, for those who do not see it. */
  describe(text: string): void {
    this.renderer.domElement.setAttribute('aria-label', text);
  }

  /** In the next frame, once, however often it is asked for. */
  draw(): void {
    if (this.awaited) return;
    this.awaited = true;
    requestAnimationFrame(() => {
      if (this.ended) return;
      this.awaited = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  /** Turns the camera to where the points are seen best, all of them; or from that side, a unit vector. */
  lookAt(points: Vector3[], eye?: Vector3): void {
    this.seen = points;
    this.eye = eye;
    this.camera.position.copy(eye ? viewFrom(eye, points, this.camera) : viewOf(points, this.camera));
    this.controls.update();
    this.draw();
  }

  replace(before: Object3D | undefined, after: Object3D): void {
    if (before) {
      this.scene.remove(before);
      release(before);
    }
    this.scene.add(after);
    this.draw();
  }

  /** Gives the graphics memory back, and the context, of which a browser has few. */
  private end(): void {
    this.ended = true;
    release(this.scene);
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private fit(frame: HTMLElement): void {
    const { clientWidth: width, clientHeight: height } = frame;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.seen.length > 0) this.lookAt(this.seen, this.eye);
    this.draw();
  }
}

/** Frees what the graphics memory holds of an object. */
export function release(object: Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as { geometry?: { dispose(): void }; material?: { dispose(): void } };
    geometry?.dispose();
    material?.dispose();
  });
}
