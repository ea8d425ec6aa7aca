// SPDX-License-Identifier: Apache-2.0
// A key that is turned by hand: one step of the history, with the time at the key.
import { exponential, product, type Vector } from 'orispline-viewer/motion/quaternion';
import type { Key, StudioDocument } from '../document/document';
import { turnedTo } from '../edits/turn';
import type { Studio } from '../store/studio';

export class TurnByHand {
  private readonly before: StudioDocument;
  private readonly gesture = {};

  constructor(
    private readonly studio: Studio,
    readonly key: Key,
  ) {
    this.before = studio.store.current().document;
    studio.view.choose({ time: key.t, playing: false });
  }

  /** By a rotation vector in the world [rad], from where it began. */
  turn(by: Vector): void {
    const { store } = this.studio;
    store.edit(turnedTo(store.current().document, this.key.id, product(exponential(by), [...this.key.q])), this.gesture);
  }

  giveUp(): void {
    this.studio.store.edit(this.before, this.gesture);
  }
}
