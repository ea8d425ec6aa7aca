// SPDX-License-Identifier: Apache-2.0
// One graphics context for all scenes of a viewer, since a browser has few. What it paints is copied to the scene's own canvas, where it
// stays: for printing, and where the browser takes the context away.
import { WebGLRenderer, type PerspectiveCamera, type Scene } from 'three';
import type { Store } from '../store/store';

const sharpest = 2; // pixels of the canvas in one of the page

export interface Size {
  width: number; // pixels of the page
  height: number;
}

export class Painter {
  private readonly renderer: WebGLRenderer;
  private readonly size: Size = { width: 0, height: 0 }; // of the largest scene
  private readonly watchers: ((isLost: boolean) => void)[] = [];
  private isLost = false;

  /** `context`: of a canvas of its own. */
  constructor(store: Store, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas: context.canvas, context, alpha: true });
    this.renderer.setScissorTest(true);
    const tell = (isLost: boolean) => () => {
      this.isLost = isLost;
      for (const watcher of this.watchers) watcher(isLost);
    };
    const { domElement } = this.renderer;
    store.listen(domElement, 'webglcontextlost', tell(true));
    store.listen(domElement, 'webglcontextrestored', tell(false));
    store.atEnd(() => {
      this.renderer.dispose();
      this.renderer.forceContextLoss();
    });
  }

  /** Tells when the context is lost, and when it is there again. */
  watch(watcher: (isLost: boolean) => void): void {
    this.watchers.push(watcher);
  }

  paint(scene: Scene, camera: PerspectiveCamera, canvas: HTMLCanvasElement, { width, height }: Size): void {
    if (this.isLost) return;
    this.makeRoom(width, height);
    this.renderer.setViewport(0, 0, width, height);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.render(scene, camera);
    const ratio = this.renderer.getPixelRatio();
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
    const context = canvas.getContext('2d')!;
    context.clearRect(0, 0, wide, high);
    context.drawImage(this.renderer.domElement, 0, this.renderer.domElement.height - high, wide, high, 0, 0, wide, high);
  }

  private makeRoom(width: number, height: number): void {
    const ratio = Math.min(devicePixelRatio, sharpest);
    const isNew = ratio !== this.renderer.getPixelRatio();
    if (!isNew && width <= this.size.width && height <= this.size.height) return;
    this.size.width = Math.ceil(Math.max(this.size.width, width));
    this.size.height = Math.ceil(Math.max(this.size.height, height));
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.size.width, this.size.height, false);
  }
}
