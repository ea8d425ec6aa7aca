// SPDX-License-Identifier: Apache-2.0
// The document that is edited and its steps, kept in the browser so that they survive a reload: under the hash of what was opened, since all files that
// are opened from a disk share one store. Keeping it never fails; where it cannot be kept, one sentence says so.
import type { StudioDocument } from '../document/document';
import { sameDocument } from '../document/same';
import { draftIn, draftText, timeOf } from './draftText';
import type { StudioStore, Work } from './store';

/** As `localStorage` is. */
export type Shelf = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

export interface Clock {
  now(): number; // [ms]
  later(call: () => void, delay: number): void; // [ms]
}

export interface DraftSetting {
  hash: string; // of what was opened, with what the user has said of it
  opened: StudioDocument;
  shelf: () => Shelf; // which may throw
  tell: (sentence: string) => void;
  clock?: Clock;
}

const prefix = 'orispline-studio:';
const mostDrafts = 20;
const delay = 400; // [ms] between two writings, at least
const shorter = [100, 10, 0]; // steps that are kept where there is no room for all

const browserClock: Clock = { now: () => Date.now(), later: (call, milliseconds) => void setTimeout(call, milliseconds) };

/** Names of all drafts on the shelf, the newest first. */
function draftsOn(shelf: Shelf): string[] {
  const names = Array.from({ length: shelf.length }, (_, i) => shelf.key(i)).filter((name) => name?.startsWith(prefix)) as string[];
  const times = new Map(names.map((name) => [name, timeOf(shelf.getItem(name))]));
  return names.sort((one, other) => times.get(other)! - times.get(one)!);
}

/** Writes; where there is no more room the oldest drafts of other files go first. */
function put(shelf: Shelf, name: string, text: string): void {
  for (;;)
    try {
      return shelf.setItem(name, text);
    } catch (error) {
      const oldest = draftsOn(shelf).findLast((other) => other !== name);
      if (!oldest) throw error;
      shelf.removeItem(oldest);
    }
}

/** The first of some texts that there is room for. */
function putFirst(shelf: Shelf, name: string, [text, ...others]: (() => string)[]): void {
  try {
    put(shelf, name, text());
  } catch (error) {
    if (others.length === 0) throw error;
    putFirst(shelf, name, others);
  }
}

export class Draft {
  private readonly name: string;
  private readonly clock: Clock;
  private waiting: Work | null = null;
  private isTimed = false;
  private hasTold = false;

  constructor(private readonly setting: DraftSetting) {
    this.name = prefix + setting.hash;
    this.clock = setting.clock ?? browserClock;
  }

  /** What was kept last; null where there is none, or where it is damaged or of another version. */
  read(): Work | null {
    try {
      return draftIn(this.setting.shelf().getItem(this.name), this.setting.opened);
    } catch {
      return null;
    }
  }

  /** Keeps each document of a store, until what it returns is called. */
  follow(store: StudioStore): () => void {
    let isFirst = true;
    return store.subscribe(['document', 'isSaved'], () => {
      if (!isFirst) this.keep(store.work());
      isFirst = false;
    });
  }

  keep(work: Work): void {
    this.waiting = work;
    if (this.isTimed) return;
    this.isTimed = true;
    this.clock.later(() => {
      this.isTimed = false;
      this.flush();
    }, delay);
  }

  /** Writes now what waits; for when the page is hidden. */
  flush(): void {
    const work = this.waiting;
    this.waiting = null;
    if (work) this.attempt((shelf) => this.write(shelf, work));
  }

  drop(): void {
    this.waiting = null;
    this.attempt((shelf) => shelf.removeItem(this.name));
  }

  private write(shelf: Shelf, work: Work): void {
    if (work.past.length + work.future.length === 0 && sameDocument(work.document, this.setting.opened)) return shelf.removeItem(this.name);
    const time = this.clock.now();
    putFirst(shelf, this.name, [Infinity, ...shorter.filter((most) => most < work.past.length)].map((most) => () => draftText(work, time, most)));
    for (const old of draftsOn(shelf).slice(mostDrafts)) shelf.removeItem(old);
  }

  private attempt(work: (shelf: Shelf) => void): void {
    let shelf: Shelf | undefined;
    try {
      shelf = this.setting.shelf();
      work(shelf);
      this.hasTold = false;
    } catch {
      if (this.hasTold) return;
      this.hasTold = true;
      const found = shelf ? 'has no room left for the draft' : 'keeps nothing for this page';
      this.setting.tell(`This browser ${found}, so that what you edit is lost with the page. Save the keys before you close it.`);
    }
  }
}
