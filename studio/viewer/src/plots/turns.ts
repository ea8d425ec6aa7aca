// SPDX-License-Identifier: Apache-2.0
// When plots are drawn: those in view in the next frame, all others while the browser has nothing else to do.
import type { Store } from '../store/store';

export interface Drawable {
  readonly figure: HTMLElement;
  draw: () => void;
}

const pause = 60; // [ms] where the browser does not say when it rests
const patience = 500; // [ms] where it never says so, as Chromium does in some frames

const whenIdle = (work: () => void) => ('requestIdleCallback' in window ? requestIdleCallback(work, { timeout: patience }) : setTimeout(work, pause));

export class Turns {
  private readonly waiting = new Set<Drawable>();
  private readonly inView = new Set<Element>();
  private readonly observer = new IntersectionObserver((entries) => this.see(entries));
  private isAsked = false;

  constructor(store: Store) {
    store.atEnd(() => {
      this.observer.disconnect();
      this.waiting.clear();
    });
  }

  add({ figure }: Drawable): void {
    this.observer.observe(figure);
  }

  /** It is to be drawn, once, however often it is asked for. */
  ask(one: Drawable): void {
    this.waiting.add(one);
    one.figure.setAttribute('aria-busy', 'true');
    this.next();
  }

  /** Now, such as for printing. */
  drawAll(): void {
    for (const one of this.waiting) this.draw(one);
  }

  private see(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) isIntersecting ? this.inView.add(target) : this.inView.delete(target);
    this.next();
  }

  private next(): void {
    if (this.isAsked || this.waiting.size === 0) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      for (const one of this.waiting) if (this.inView.has(one.figure)) this.draw(one);
      if (this.waiting.size > 0) whenIdle(() => this.rest());
    });
  }

  private rest(): void {
    const [one] = this.waiting;
    if (!one) return;
    this.draw(one);
    if (this.waiting.size > 0) whenIdle(() => this.rest());
  }

  private draw(one: Drawable): void {
    this.waiting.delete(one);
    one.figure.removeAttribute('aria-busy');
    one.draw();
  }
}
