// SPDX-License-Identifier: Apache-2.0
// One document that is open: its store, its view, its draft, and its curves as they come.
import { Store as ViewStore } from 'orispline-viewer/store/store';
import { keyWith, type StudioDocument } from '../document/document';
import { sameDocument } from '../document/same';
import { sentence } from '../document/sentence';
import type { Curves, Engine, MethodInfo, Opened, Warning } from '../engine/protocol';
import { Draft } from '../store/draft';
import { looked, looksOf, type Looks } from '../store/kept';
import { Shown } from '../store/shown';
import { createStore, type Work } from '../store/store';
import type { Studio } from '../store/studio';
import { copiesOf } from './copying';
import { exportsOf } from './exporting';
import type { Action } from './notices';
import type { FileHandle, Given } from './opening';
import { Saving } from './saving';
import { Screen } from './screen';

export interface Setting {
  engine: Engine;
  methods: readonly MethodInfo[];
  looks: Looks;
  handle?: FileHandle;
  open: () => void;
  begins?: (given: Given) => void; // where this is what the page opens with: takes what comes in its place
  cures: (warning: Warning) => Action[]; // what the user may say of the file
}

export class Session {
  readonly studio: Studio;
  readonly screen: Screen;
  private readonly shown = new Shown();
  private readonly asked = new WeakSet<StudioDocument>(); // documents whose curves are this session's
  private readonly endings: (() => void)[] = [];
  private readonly plays: boolean; // by itself
  private chosen: { id: number | null; t: number } = { id: null, t: NaN };

  /** `curves`: those of the document that is shown first, which is the draft's where there is one. */
  constructor({ original, document, warnings }: Opened, work: Work | null, curves: Curves, private readonly draft: Draft, { engine, methods, looks, handle, open, begins, cures }: Setting) {
    const first = work?.document ?? document;
    const store = createStore(first, work?.saved ?? document, work ?? undefined);
    store.tellCurves(curves);
    const view = new ViewStore(this.shown.report(first, curves));
    view.choose({ components: false, ...looks });
    this.studio = { store, view, engine, methods, original };
    const saving = new Saving(this.studio, document, handle, () => this.screen);
    const place = () => this.screen.element;
    const tell = (sentence: string) => this.screen.notices.tell(sentence);
    this.screen = new Screen(this.studio, { open, save: () => void saving.save(), copies: copiesOf(this.studio, place, tell), exports: exportsOf(this.studio, place, tell) }, begins && { open, given: begins });
    this.plays = begins !== undefined && first === document;
    for (const warning of warnings) this.screen.notices.tell(sentence(warning.message), { isTrouble: true, actions: cures(warning) });
    this.follow();
    this.keep(document, first);
  }

  get looks(): Looks {
    return looksOf(this.studio.view.current());
  }

  /** Tells how things are looked at, now and whenever that is changed. */
  onLooks(tell: (looks: Looks) => void): void {
    this.studio.view.subscribe([...looked], (state) => tell(looksOf(state)));
  }

  /** The curves of a document that may be this session's. */
  take(curves: Curves, of: StudioDocument): void {
    if (!this.asked.has(of)) return;
    const { store, view } = this.studio;
    store.tellCurves(curves, of);
    const { t } = this.chosen;
    const isAtKey = view.current().time === t;
    view.replace(this.shown.report(of, curves));
    if (isAtKey) view.choose({ time: t }); // the curves may be those of an earlier document, which end before
  }

  /** When it is on the page. What moves by itself is still for those who want no motion, and while nobody sees it. */
  begin(): void {
    this.screen.begin();
    const still = matchMedia('(prefers-reduced-motion: reduce)');
    if (!this.plays || still.matches) return;
    const { view } = this.studio;
    let moves = true;
    view.choose({ time: view.current().extent[0], playing: !document.hidden });
    view.listen(document, 'visibilitychange', () => {
      if (document.hidden) moves = view.current().playing;
      view.choose({ playing: moves && !document.hidden && !still.matches });
    });
    view.listen(still, 'change', () => still.matches && view.choose({ playing: false }));
  }

  end(): void {
    for (const ending of this.endings) ending();
    this.studio.view.destroy();
  }

  /** New curves for each document; the time goes where the chosen key is. */
  private follow(): void {
    const { store, view, engine } = this.studio;
    this.endings.push(
      store.subscribe(['document'], ({ document }) => {
        this.asked.add(document);
        engine.draw(document);
      }),
      store.subscribe(['document', 'chosen'], ({ document, chosen }) => {
        const t = keyWith(document, chosen)?.t ?? NaN;
        const isOther = chosen !== this.chosen.id || t !== this.chosen.t;
        this.chosen = { id: chosen, t };
        if (isOther && !Number.isNaN(t)) this.goTo(t);
      }),
    );
    view.choose({ playing: false });
  }

  /** The extent follows the keys when their curves come; until then the time may be beyond it. */
  private goTo(t: number): void {
    const { view } = this.studio;
    const { window: [from, to], extent } = view.current();
    view.choose({ playing: false, time: t });
    if (t >= from && t <= to) return;
    const span = to - from;
    const first = Math.min(Math.max(t - span / 2, extent[0]), extent[1] - span);
    view.choose({ window: [first, first + span] });
  }

  /** What is edited survives, whatever comes next. */
  keepDraft = (): void => this.draft.flush();

  private keep(opened: StudioDocument, first: StudioDocument): void {
    const { draft } = this;
    const { store, original } = this.studio;
    addEventListener('pagehide', this.keepDraft);
    this.endings.push(draft.follow(store), this.keepDraft, () => removeEventListener('pagehide', this.keepDraft));
    if (sameDocument(first, opened)) return;
    const discard = () => {
      store.edit(opened);
      draft.drop();
    };
    this.screen.notices.tell(`Your edits of ${original.name} from before are here again.`, { actions: [{ label: 'Discard draft', chosen: discard }] });
  }
}
