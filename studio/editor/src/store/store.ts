// SPDX-License-Identifier: Apache-2.0
// The document as it is edited. Nothing else writes it.
import { keyWith, type StudioDocument, type Which } from '../document/document';
import { sameDocument } from '../document/same';
import type { Curves, Drawn, Trouble } from '../engine/protocol';
import { History, type Steps } from './history';

export interface State {
  document: StudioDocument;
  chosen: number | null; // id of a key
  canUndo: boolean;
  canRedo: boolean;
  isSaved: boolean; // the document is what was opened or saved last
  curvesOf: StudioDocument | null; // whose curves these are, which may be an earlier one
  curves: Curves | null; // of the newest document that was drawn; where a choice has none, those that it had last are in the view
  troubles: Record<Which, Trouble | null>; // why a choice has no curve through the keys as they are
}

type Field = keyof State;

/** The edits of one gesture are one step of the history. */
export interface StudioStore {
  current: () => Readonly<State>;
  /** Calls the update now, and again when one of the fields changes, until what it returns is called. */
  subscribe: (fields: Field[], update: (state: Readonly<State>) => void) => () => void;
  choose: (id: number | null) => void;
  edit: (next: StudioDocument, gesture?: object) => void;
  undo: () => void;
  redo: () => void;
  tellCurves: (curves: Curves, of?: StudioDocument) => void;
  tellSaved: () => void;
  /** All that is to survive a reload. */
  work: () => Work;
}

/** What is edited, the steps before it and those that were undone, and what the file holds, as far as it is known. */
export interface Work extends Steps {
  readonly document: StudioDocument;
  readonly saved: StudioDocument | null;
}

const troubleOf = (drawn: Drawn): Trouble | null => ('trouble' in drawn ? drawn.trouble : null);

const sameTroubles = (some: State['troubles'], others: State['troubles']): boolean =>
  (['first', 'second'] as const).every((which) => some[which]?.message === others[which]?.message && some[which]?.key === others[which]?.key);

/** The store of a document; `saved`: what the file holds, where that is another one, such as before a draft, whose steps it may begin with. */
export function createStore(opened: StudioDocument, saved: StudioDocument = opened, steps?: Steps): StudioStore {
  const history = new History(opened, steps);
  const subscribers = new Set<{ fields: Field[]; update: (state: Readonly<State>) => void }>();
  let file = saved;
  let state: State = {
    document: opened,
    chosen: opened.keys[0]?.id ?? null,
    canUndo: history.canUndo,
    canRedo: history.canRedo,
    isSaved: sameDocument(opened, saved),
    curvesOf: null,
    curves: null,
    troubles: { first: null, second: null },
  };

  function change(changes: Partial<State>): void {
    const changed = (Object.keys(changes) as Field[]).filter((field) => changes[field] !== state[field]);
    if (changed.length === 0) return;
    state = { ...state, ...changes };
    for (const { fields, update } of [...subscribers]) if (fields.some((field) => changed.includes(field))) update(state);
  }

  /** What follows from the history: the key that was chosen stays so while there is one. */
  function show(): void {
    const { now: document, canUndo, canRedo } = history;
    const chosen = keyWith(document, state.chosen) ? state.chosen : nearest(document);
    change({ document, chosen, canUndo, canRedo, isSaved: sameDocument(document, file) });
  }

  /** In the place of a chosen key that is no more: the one that is there by time. */
  function nearest({ keys }: StudioDocument): number | null {
    const t = keyWith(state.document, state.chosen)?.t;
    if (t === undefined) return null;
    return keys.reduce<(typeof keys)[number] | null>((best, key) => (best && Math.abs(best.t - t) <= Math.abs(key.t - t) ? best : key), null)?.id ?? null;
  }

  return {
    current: () => state,
    subscribe(fields, update) {
      const subscriber = { fields, update };
      subscribers.add(subscriber);
      update(state);
      return () => subscribers.delete(subscriber);
    },
    choose: (id) => change({ chosen: keyWith(state.document, id) ? id : null }),
    edit(next, gesture) {
      history.edit(next, gesture);
      show();
    },
    undo() {
      history.undo();
      show();
    },
    redo() {
      history.redo();
      show();
    },
    tellCurves(curves, of = state.document) {
      const troubles = { first: troubleOf(curves.first), second: troubleOf(curves.second) };
      change({ curves, curvesOf: of, troubles: sameTroubles(troubles, state.troubles) ? state.troubles : troubles });
    },
    work: () => ({ document: history.now, saved: file, ...history.steps }),
    tellSaved() {
      file = state.document;
      change({ isSaved: true });
    },
  };
}
