// SPDX-License-Identifier: Apache-2.0
// The document as it is edited. Nothing else writes it.
import type { StudioDocument, Which } from '../document/document';
import type { Curves, Trouble } from '../engine/protocol';

export interface State {
  document: StudioDocument;
  chosen: number | null; // id of a key
  canUndo: boolean;
  canRedo: boolean;
  isSaved: boolean; // the document is what was opened or saved last
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
  tellCurves: (curves: Curves) => void;
  tellSaved: () => void;
}
