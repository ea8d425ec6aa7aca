// SPDX-License-Identifier: Apache-2.0
// The worker as the page sees it.
import browsers from '../document/browsers.json';
import type { StudioDocument } from '../document/document';
import type { Redrawn } from './drawings';
import { Latest } from './latest';
import type { Answered, Asked } from './messages';
import { stopped, type Curves, type Drawn, type Engine, type Given, type Name, type Told, type Trouble } from './protocol';
import { troubleOf } from './trouble';

type Listener = (curves: Curves, of: StudioDocument) => void;
type Waiting = { resolve: (told: unknown) => void; reject: (trouble: Trouble) => void; progress?: (share: number) => void };

/** Samples that are drawn of so many keys. */
const countFor = (keys: number): number => Math.max(600, 4 * keys + 1);

const without: Trouble = { message: `The library cannot be started here, since this browser gives the page no worker; open the page in ${browsers.wanted}.` };
const closed: Trouble = { message: 'The library was closed, so it answers no more; load the page again.' };

export class WorkerEngine implements Engine {
  private worker: Worker | null;
  private readonly waiting = new Map<number, Waiting>();
  private readonly listeners: Listener[] = [];
  private readonly drawings = new Latest<StudioDocument>((document) => this.drawn(document));
  private curves: Curves | null = null;
  private failed: Trouble | null = null;
  private last = 0;

  /** `library`: the bytes of its .wasm, compressed by gzip and written as base64. */
  constructor(
    private readonly start: () => Worker,
    private readonly library: string,
  ) {
    this.worker = this.started();
    this.post({ library });
  }

  ask<N extends Exclude<Name, 'curves'>>(name: N, given: Given<N>, progress?: (share: number) => void): Promise<Told<N>> {
    return this.asked(name, given, progress) as Promise<Told<N>>;
  }

  draw(document: StudioDocument): void {
    this.drawings.put(document);
  }

  onCurves(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** The library cannot be interrupted, so that its worker is ended and another one begins. */
  stop(): void {
    if (this.failed) return;
    this.worker?.terminate();
    this.refuse(stopped);
    this.worker = this.started();
    this.post({ library: this.library });
  }

  close(): void {
    this.worker?.terminate();
    this.fail(closed);
  }

  private started(): Worker | null {
    try {
      const worker = this.start();
      worker.addEventListener('message', ({ data }: MessageEvent<Answered>) => this.take(data));
      worker.addEventListener('error', (event) => {
        event.preventDefault();
        this.fail(event.message ? { message: `The worker with the library has ended: ${event.message}. Load the page again.` } : without);
      });
      return worker;
    } catch {
      this.failed = without;
      return null;
    }
  }

  private post(asked: Asked): void {
    this.worker?.postMessage(asked);
  }

  private asked(name: Name, given: Given<Name>, progress?: (share: number) => void): Promise<unknown> {
    return new Promise((resolve, reject) => {
      if (this.failed) return reject(this.failed);
      this.waiting.set(++this.last, { resolve, reject, progress });
      this.post({ number: this.last, name, given });
    });
  }

  private take(answered: Answered): void {
    const waiting = this.waiting.get(answered.number);
    if ('share' in answered) return waiting?.progress?.(answered.share);
    this.waiting.delete(answered.number);
    if ('trouble' in answered) waiting?.reject(answered.trouble);
    else waiting?.resolve(answered.told);
  }

  private fail(trouble: Trouble): void {
    this.failed ??= trouble;
    this.refuse(trouble);
  }

  private refuse(trouble: Trouble): void {
    for (const { reject } of this.waiting.values()) reject(trouble);
    this.waiting.clear();
  }

  private async drawn(document: StudioDocument): Promise<void> {
    let curves: Curves;
    try {
      const told = (await this.asked('curves', { document, count: countFor(document.keys.length) })) as Redrawn;
      const whole = (which: keyof Curves): Drawn => (told[which] === 'same' ? this.curves![which] : told[which]);
      curves = this.curves = { first: whole('first'), second: whole('second') };
    } catch (reason) {
      if (reason === stopped) return this.drawn(document);
      const trouble = troubleOf(reason);
      curves = { first: { trouble }, second: { trouble } };
    }
    for (const listener of this.listeners) listener(curves, document);
  }
}
