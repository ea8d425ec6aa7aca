// SPDX-License-Identifier: Apache-2.0
// What is done to keys from the timeline, and from anywhere by keyboard.
import { keyWith, type Key } from '../document/document';
import { sentence } from '../document/sentence';
import { deleted, duplicated, inserted, type WithNewKey } from '../edits/keys';
import { notDeleted } from '../edits/reasons';
import { movedInTime } from '../edits/time';
import type { Trouble } from '../engine/protocol';
import type { Studio } from '../store/studio';

export class Actions {
  constructor(
    private readonly studio: Studio,
    private readonly tell: (sentence: string) => void,
  ) {}

  get chosen(): Key | undefined {
    const { document, chosen } = this.studio.store.current();
    return keyWith(document, chosen);
  }

  /** On the curve, else on that beside it. */
  async insert(time: number): Promise<void> {
    const { store, engine } = this.studio;
    const { document, troubles } = store.current();
    const choice = troubles.first && !troubles.second ? document.second : document.first;
    try {
      const pose = await engine.ask('at', { keys: document.keys, choice, time });
      if (store.current().document !== document) return this.tell('The keys have changed meanwhile, so that no key was inserted. Insert it again.');
      this.show(inserted(document, time, pose), 'There is a key so near to that time that there is no room for another one. Choose another time.');
    } catch (trouble) {
      this.tell(sentence((trouble as Trouble).message));
    }
  }

  duplicate(): void {
    const { chosen } = this;
    if (chosen) this.show(duplicated(this.studio.store.current().document, chosen.id), 'The next key is so near that there is no room for another one. Move it first.');
  }

  private show({ document, id }: WithNewKey, why: string): void {
    if (id === null) return this.tell(why);
    this.studio.store.edit(document);
    this.studio.store.choose(id);
  }

  remove(): void {
    const { store } = this.studio;
    const { document } = store.current();
    const why = notDeleted(document);
    if (why) this.tell(why);
    else if (this.chosen) store.edit(deleted(document, this.chosen.id));
  }

  move(id: number, time: number, gesture: object): void {
    const { store } = this.studio;
    store.edit(movedInTime(store.current().document, id, time), gesture);
  }

  /** The key so many places on, or the first or last one. */
  step(by: number): void {
    const { store } = this.studio;
    const { document, chosen } = store.current();
    const here = document.keys.findIndex(({ id }) => id === chosen);
    const there = Math.min(Math.max(here + by, 0), document.keys.length - 1);
    store.choose(document.keys[there].id);
  }
}
