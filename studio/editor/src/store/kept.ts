// SPDX-License-Identifier: Apache-2.0
// What a page remembers beside drafts: how things are looked at, for all files of this browser; and for a reload of this page the file that is open.
// Where the browser keeps nothing, nothing is remembered.
import type { State } from 'orispline-viewer/store/store';
import { plainReading } from '../document/reading';
import type { Original, StudioDocument } from '../document/document';
import { draftIn, draftText } from './draftText';
import type { Shelf } from './draft';

export const looked = ['theme', 'up', 'body', 'axis', 'components', 'speed'] as const; // fields of the view

export type Looks = Partial<Pick<State, (typeof looked)[number]>>;

const allowed: { readonly [Field in (typeof looked)[number]]: (value: unknown) => boolean } = {
  theme: (value) => value === 'light' || value === 'dark',
  up: (value) => value === 'y' || value === 'z',
  body: (value) => typeof value === 'string' && /^[a-z]{1,20}$/.test(value),
  axis: (value) => value === 'x' || value === 'y' || value === 'z',
  components: (value) => typeof value === 'boolean',
  speed: (value) => typeof value === 'number' && value > 0 && value <= 100,
};

const looksName = 'orispline-studio-looks', openName = 'orispline-studio-open ';

function looksIn(value: unknown): Looks {
  const found = Object.entries((value ?? {}) as object).filter(([field, one]) => looked.some((name) => name === field) && allowed[field as keyof typeof allowed](one));
  return Object.fromEntries(found);
}

const systemTheme = (): State['theme'] => (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');

/** Without the theme where it is that of the system, which is followed on. */
export const looksOf = (state: Readonly<State>): Looks =>
  Object.fromEntries(looked.filter((field) => field !== 'theme' || state.theme !== systemTheme()).map((field) => [field, state[field]]));

/** Does nothing where the browser keeps nothing. */
function attempt<Result>(work: () => Result): Result | null {
  try {
    return work();
  } catch {
    return null;
  }
}

export const keepLooks = (shelf: () => Shelf, looks: Looks): void => void attempt(() => shelf().setItem(looksName, JSON.stringify(looks)));

export const keptLooks = (shelf: () => Shelf): Looks => attempt(() => looksIn(JSON.parse(shelf().getItem(looksName) ?? '{}'))) ?? {};

/** What is open: as it was opened, and how it is looked at. */
export interface Open {
  readonly original: Original;
  readonly document: StudioDocument;
  readonly looks: Looks;
}

/** `page`: which page of this tab. */
export function keepOpen(shelf: () => Shelf, page: string, { original, document, looks }: Open): void {
  attempt(() => shelf().removeItem(openName + page)); // rather nothing than another file, where the next does not fit
  attempt(() => shelf().setItem(openName + page, JSON.stringify({ original, looks, document: draftText({ document, past: [], future: [], saved: null }, 0) })));
}

const isText = (value: unknown): value is string => typeof value === 'string';

export function keptOpen(shelf: () => Shelf, page: string): Open | null {
  return attempt(() => {
    const { original, looks, document } = JSON.parse(shelf().getItem(openName + page)!);
    const { name, text, hash, epoch, reading = plainReading } = original;
    if (![name, text, hash, epoch, document].every(isText) || typeof reading.options !== 'object' || typeof reading.comma !== 'boolean') return null;
    const found = draftIn(document, null);
    return found && { original: { name, text, hash, epoch, ...(original.reading ? { reading } : {}) }, document: found.document, looks: looksIn(looks) };
  });
}
