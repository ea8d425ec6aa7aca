// SPDX-License-Identifier: Apache-2.0
// One graphics context for all scenes of a viewer, since a browser has few. What it paints is handed to the scene's own canvas, where it
// stays: for printing, and where the browser takes the context away.
import { WebGLRenderer, type PerspectiveCamera, type Scene } from 'three';
import type { Store } from '../store/store';

const sharpest = 2; // pixels of the canvas in one of the page
const slow = 40; // [ms] from a frame with scenes to the next one: less than 25 a second

export interface Size {
  width: number; // pixels of the page
  height: number;
}

export class Painter {
  private readonly renderer: WebGLRenderer;
  private readonly size: Size = { width: 0, height: 0 }; // of the last scene
  private readonly watchers: ((isLost: boolean) => void)[] = [];
  private readonly waiting = new Set<() => void>();
  private isRunning = false;
  private painted = 0; // when the last frame was that had scenes [ms]; 0: none
  private isSlow = false;
  private isLost = false;
  private ended = false;

  constructor(store: Store, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas: context.canvas, context, alpha: true });
    const tell = (isLost: boolean) => () => {
      this.isLost = isLost;
      for (const watcher of this.watchers) watcher(isLost);
    };
    const { domElement } = this.renderer;
    store.listen(domElement, 'webglcontextlost', tell(true));
    store.listen(domElement, 'webglcontextrestored', tell(false));
    store.atEnd(() => {
      this.ended = true;
      this.renderer.dispose();
      this.renderer.forceContextLoss();
    });
  }

  /** Tells when the context is lost, and when it is there again. */
  watch(watcher: (isLost: boolean) => void): void {
    this.watchers.push(watcher);
  }

  /**
   * In the next frame, once, however often it is asked for. Where graphics are slow, such as those without an accelerator, it is one scene a
   * frame, so that the first one and all else follow the user soon.
   */
  ask(paint: () => void): void {
    this.waiting.add(paint); // behind those that wait
    if (!this.isRunning) requestAnimationFrame(this.frame);
    this.isRunning = true;
  }

  private frame = (now: number): void => {
    if (this.ended) return;
    if (this.painted > 0) this.isSlow = now - this.painted > slow;
    this.isRunning = this.waiting.size > 0;
    this.painted = this.isRunning ? now : 0;
    for (const paint of this.waiting) {
      this.waiting.delete(paint);
      paint();
      if (this.isSlow) break;
    }
    if (this.isRunning) requestAnimationFrame(this.frame); // if but to see how long it took
  };

  /** Hands the picture over as it is: to copy it would wait for the graphics. */
  paint(scene: Scene, camera: PerspectiveCamera, canvas: HTMLCanvasElement, size: Size): void {
    if (this.isLost) return;
    this.fit(size);
    this.renderer.render(scene, camera);
    const picture = (this.renderer.domElement as unknown as OffscreenCanvas).transferToImageBitmap();
    if (canvas.width !== picture.width || canvas.height !== picture.height) Object.assign(canvas, { width: picture.width, height: picture.height });
    canvas.getContext('bitmaprenderer')!.transferFromImageBitmap(picture);
  }

  private fit({ width, height }: Size): void {
    const ratio = Math.min(devicePixelRatio, sharpest);
    if (ratio === this.renderer.getPixelRatio() && width === this.size.width && height === this.size.height) return;
    Object.assign(this.size, { width, height });
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }
}

/** Nothing where the browser cannot draw in space. */
export function painterOf(store: Store): Painter | null {
  const context = 'OffscreenCanvas' in globalThis ? new OffscreenCanvas(1, 1).getContext('webgl2', { antialias: true }) : null;
  return context && new Painter(store, context);
}
