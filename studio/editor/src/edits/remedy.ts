// SPDX-License-Identifier: Apache-2.0
// Another method in the place of one that does not suit the keys, as the library proposes it.
import type { Choice, Setting, StudioDocument } from '../document/document';

/** `own`: values at keys that shall be as others are, where keys have these. */
export interface Proposed {
  readonly choice: Choice;
  readonly own: readonly (readonly [name: string, from: string])[];
}

/** What keys have of their own is no setting. */
export function remedied(document: StudioDocument, { choice, own }: Proposed): StudioDocument {
  const had = document.keys[0]?.own ?? {};
  const tied = own.filter(([, from]) => from in had);
  const names = [...Object.keys(had), ...tied.map(([name]) => name)];
  const settings = Object.fromEntries(Object.entries(choice.settings).filter(([name]): boolean => !names.includes(name))) as Record<string, Setting>;
  const keys = document.keys.map((key) => (tied.length === 0 ? key : { ...key, own: { ...key.own, ...Object.fromEntries(tied.map(([name, from]) => [name, key.own[from]])) } }));
  return { ...document, keys, first: { method: choice.method, settings } };
}
