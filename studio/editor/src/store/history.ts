// SPDX-License-Identifier: Apache-2.0
// All documents that there were, of which one is now. The past has no end; documents share what did not change.
import type { StudioDocument } from '../document/document';
import { sameDocument } from '../document/same';

export interface Steps {
  readonly past: readonly StudioDocument[];
  readonly future: readonly StudioDocument[];
}

export class History {
  private readonly past: StudioDocument[];
  private future: StudioDocument[]; // the nearest one last
  private gesture: object | undefined; // of which the last step is
  private undone: StudioDocument[] = []; // the future before that step

  constructor(private document: StudioDocument, steps: Steps = { past: [], future: [] }) {
    this.past = [...steps.past];
    this.future = [...steps.future];
  }

  /** What was, and what was undone, the nearest one last. */
  get steps(): Steps {
    return { past: this.past, future: this.future };
  }

  get now(): StudioDocument {
    return this.document;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** All edits of one gesture are one step; a gesture that comes back to where it began leaves none. */
  edit(next: StudioDocument, gesture?: object): void {
    if (gesture && gesture === this.gesture) {
      this.document = next;
      if (!sameDocument(next, this.past[this.past.length - 1])) return;
      this.document = this.past.pop()!;
      this.future = this.undone;
      this.gesture = undefined;
      return;
    }
    this.gesture = undefined;
    if (next === this.document || sameDocument(next, this.document)) return;
    this.past.push(this.document);
    this.undone = this.future;
    this.future = [];
    this.document = next;
    this.gesture = gesture;
  }

  undo(): void {
    this.step(this.past, this.future);
  }

  redo(): void {
    this.step(this.future, this.past);
  }

  private step(from: StudioDocument[], to: StudioDocument[]): void {
    this.gesture = undefined;
    const next = from.pop();
    if (!next) return;
    to.push(this.document);
    this.document = next;
  }
}
