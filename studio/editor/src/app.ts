// SPDX-License-Identifier: Apache-2.0
// The studio in an element of a page: the motion that it opens with, or the document that is open.
import './style/viewer.css';
import './style/studio.css';
import type { StudioDocument } from './document/document';
import { sentence } from './document/sentence';
import { motion } from './document/templates';
import { sha256 } from './engine/hash';
import type { Curves, Engine, MethodInfo, Opened, Trouble } from './engine/protocol';
import { curesOf } from './frame/cures';
import { Notices, type Action } from './frame/notices';
import { hearDrops, hearOpen, opened as openedOf, picked, type Given } from './frame/opening';
import { Session } from './frame/session';
import { product, Start } from './frame/start';
import { givenOf } from './frame/welcome';
import { Draft } from './store/draft';
import { keepLooks, keepOpen, keptLooks, keptOpen, type Looks } from './store/kept';

export class App {
  private readonly start = new Start();
  private readonly notices = new Notices(); // while nothing is open
  private page = ''; // which page this is, for a reload of it
  private methods: readonly MethodInfo[] = [];
  private session: Session | null = null;
  private opening = 0; // what is being opened
  private isReady = false;
  private awaited: { document: StudioDocument; told: (curves: Curves) => void } | null = null;

  constructor(
    private readonly place: HTMLElement,
    private readonly engine: Engine,
  ) {
    this.start.element.append(this.notices.element);
    hearDrops(place, () => this.front, (given) => void this.open(given));
    hearOpen(place, () => void this.pick());
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

  /** With what was open when this page was loaded before, else with what is given. */
  async begin(given: Given | null): Promise<void> {
    this.place.append(this.start.element);
    this.page = [location.pathname, ...(given ? [sha256(given.bytes), given.method, given.beside] : [])].join(' ');
    try {
      this.methods = await this.engine.ask('methods', null);
      this.isReady = true;
      const kept = keptOpen(() => sessionStorage, this.page);
      if (kept) await this.show({ ...kept, warnings: [] }, kept.looks);
      else if (given) await this.open(given);
      else await this.move();
    } catch (trouble) {
      this.tell(sentence((trouble as Trouble).message));
    }
  }

  /** What was open stays where the new one cannot be opened. */
  async open(given: Given, isOpening = false): Promise<void> {
    ++this.opening;
    if (!isOpening) this.told.forget();
    try {
      const opened = await openedOf(this.engine, this.front, given);
      const looks = this.session?.looks ?? keptLooks(() => localStorage);
      if (opened && !(isOpening && (this.session || this.opening > 1))) await this.show(opened, { ...looks, ...given.looks }, given, isOpening);
    } catch (reason) {
      const { message, line } = reason as Trouble;
      this.tell(`${given.name}${line === undefined ? '' : `:${line}`}: ${sentence(message)}`, curesOf(reason as Trouble, given, () => this.front, (changed) => void this.open(changed)));
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

  private get told(): Notices {
    return this.session?.screen.notices ?? this.notices;
  }

  private tell(sentence: string, actions: Action[] = []): void {
    this.told.tell(sentence, { isRefusal: true, actions });
  }

  private async pick(): Promise<void> {
    try {
      const given = await picked();
      if (given) await this.open(given);
    } catch (reason) {
      this.tell(sentence((reason as Error).message));
    }
  }

  private async show(opened: Opened, looks: Looks, given?: Given, isOpening = false): Promise<void> {
    const { original, document } = opened, { reading } = original;
    const hash = original.hash + (reading ? ` ${JSON.stringify(reading)}` : '');
    const draft = new Draft({ hash, opened: document, shelf: () => localStorage, tell: (sentence) => this.tell(sentence) });
    this.session?.keepDraft(); // it may be that of the same file
    const work = draft.read();
    const curves = await this.curvesOf(work?.document ?? document);
    this.session?.end();
    this.start.element.remove();
    const handle = original.name === given?.name ? given.handle : undefined; // keys of a recording are not written over it
    const cures = given ? (warning: { remedy?: string }) => curesOf(warning, given, () => this.front, (changed) => void this.open(changed), false) : () => [];
    const begins = isOpening ? (chosen: Given) => void this.open(chosen) : undefined;
    this.session = new Session(opened, work, curves, draft, { engine: this.engine, methods: this.methods, looks, handle, open: () => void this.pick(), begins, cures });
    this.place.append(this.session.screen.element);
    let isFirst = true;
    this.session.onLooks((now) => {
      if (!isFirst) keepLooks(() => localStorage, now);
      isFirst = false;
      if (!isOpening) keepOpen(() => sessionStorage, this.page, { original, document, looks: now });
    });
    window.document.title = isOpening ? product : `${original.name} – ${product}`;
    this.session.begin();
    this.session.screen.notices.take(this.notices); // before there was anything else
  }

  private curvesOf(document: StudioDocument): Promise<Curves> {
    return new Promise((resolve) => {
      this.awaited = { document, told: resolve };
      this.engine.draw(document);
    });
  }
}
