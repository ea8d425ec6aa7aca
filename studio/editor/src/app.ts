// SPDX-License-Identifier: Apache-2.0
// The studio in an element of a page: the motion that it opens with, or the document that is open.
import './style/viewer.css';
import './style/studio.css';
import type { StudioDocument } from './document/document';
import { sentence } from './document/sentence';
import { motion } from './document/templates';
import type { Curves, Engine, MethodInfo, Opened, Trouble } from './engine/protocol';
import { hearDrops, opened as openedOf, picked, type Given } from './frame/opening';
import { Session } from './frame/session';
import { product, Start } from './frame/start';
import { givenOf } from './frame/welcome';
import { Draft } from './store/draft';

export class App {
  private readonly start = new Start();
  private methods: readonly MethodInfo[] = [];
  private session: Session | null = null;
  private opening = 0; // what is being opened
  private isReady = false;
  private awaited: { document: StudioDocument; told: (curves: Curves) => void } | null = null;

  constructor(
    private readonly place: HTMLElement,
    private readonly engine: Engine,
  ) {
    hearDrops(place, () => this.front, (given) => void this.open(given));
    engine.onCurves((curves, of) => {
      const { awaited } = this;
      if (of === awaited?.document) {
        this.awaited = null;
        awaited.told(curves);
      } else if (awaited) engine.draw(awaited.document); // what is still open was edited meanwhile
      this.session?.take(curves, of);
    });
  }

  /** What is open, for tests and for those who want to look. */
  get current(): Session | null {
    return this.session;
  }

  async begin(given: Given | null): Promise<void> {
    this.place.append(this.start.element);
    try {
      this.methods = await this.engine.ask('methods', null);
      this.isReady = true;
      if (given) await this.open(given);
      else await this.move();
    } catch (trouble) {
      this.tell(sentence((trouble as Trouble).message));
    }
  }

  /** What was open stays where the new one cannot be opened. */
  async open(given: Given, isOpening = false): Promise<void> {
    ++this.opening;
    try {
      const opened = await openedOf(this.engine, this.front, given);
      if (opened && !(isOpening && (this.session || this.opening > 1))) await this.show(opened, given, isOpening);
    } catch (reason) {
      const { message, line } = reason as Trouble;
      this.tell(`${given.name}${line === undefined ? '' : `:${line}`}: ${sentence(message)}`);
    } finally {
      --this.opening;
    }
    if (!isOpening) await this.move();
  }

  /** Opens the motion where nothing else is open or comes. */
  private async move(): Promise<void> {
    if (this.isReady && !this.session && this.opening === 0) await this.open(givenOf(motion), true);
  }

  private get front(): HTMLElement {
    return this.session?.screen.element ?? this.start.element;
  }

  private tell(sentence: string): void {
    if (this.session) this.session.screen.notices.tell(sentence, { isTrouble: true });
    else this.start.tell(sentence);
  }

  private async pick(): Promise<void> {
    try {
      const given = await picked();
      if (given) await this.open(given);
    } catch (reason) {
      this.tell(sentence((reason as Error).message));
    }
  }

  private async show(opened: Opened, given: Given, isOpening: boolean): Promise<void> {
    const { original, document } = opened;
    const draft = new Draft({ hash: original.hash, opened: document, shelf: () => localStorage, tell: (sentence) => this.tell(sentence) });
    this.session?.keepDraft(); // it may be that of the same file
    const first = draft.read() ?? document;
    const curves = await this.curvesOf(first);
    const theme = this.session?.theme ?? null;
    this.session?.end();
    this.start.element.remove();
    const handle = original.name === given.name ? given.handle : undefined; // keys of a recording are not written over it
    const setting = { engine: this.engine, methods: this.methods, theme, looks: given.looks, handle, open: () => void this.pick(), begins: isOpening ? (given: Given) => void this.open(given) : undefined };
    this.session = new Session(opened, first, curves, draft, setting);
    this.place.append(this.session.screen.element);
    window.document.title = isOpening ? product : `${original.name} – ${product}`;
    this.session.begin();
    if (this.start.told) this.tell(this.start.told); // before there was anything else
    this.start.tell('');
  }

  private curvesOf(document: StudioDocument): Promise<Curves> {
    return new Promise((resolve) => {
      this.awaited = { document, told: resolve };
      this.engine.draw(document);
    });
  }
}
