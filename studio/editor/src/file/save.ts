// SPDX-License-Identifier: Apache-2.0
// The text of the file that keys are saved in.
import type { Key, Original, StudioDocument } from '../document/document';
import { sameChoice, sameContent } from '../document/same';
import { countedFromFirst } from '../document/times';
import type { Engine } from '../engine/protocol';
import { withRecipe } from './recipe';
import { composed } from './rows';

export interface Saved {
  readonly text: string;
  readonly isWhole: boolean; // all rows are written anew, without the comments and further columns that there were
}

/** Whether a file holds these keys, bit by bit. Its times count from its first key on. */
export function sameKeys(read: readonly Key[], keys: readonly Key[]): boolean {
  const counted = countedFromFirst(keys);
  return read.length === keys.length && read.every((key, i) => sameContent(key, counted[i]));
}

/** The rows of the file with what was changed; null where the file is no simple one, or the library reads something else out of them. */
async function changedRows(original: Original, document: StudioDocument, engine: Engine, opened?: StudioDocument): Promise<string | null> {
  const { name } = original;
  try {
    const before = await engine.ask('read', { text: original.text, name });
    const rows = composed(original, before, document.keys);
    if (rows === null) return null;
    const text = opened && sameChoice(opened.first, document.first) ? rows : withRecipe(rows, document.first);
    return sameKeys(await engine.ask('read', { text, name }), document.keys) ? text : null;
  } catch {
    return null; // what cannot be read is written anew
  }
}

/** `opened`: the document as it was opened. Where its A is as it was, the comment that names a method is too. */
export async function savedText(original: Original, document: StudioDocument, engine: Engine, opened?: StudioDocument): Promise<Saved> {
  const text = await changedRows(original, document, engine, opened);
  if (text !== null) return { text, isWhole: false };
  const given = { keys: document.keys, epoch: original.epoch, name: original.name, choice: document.first };
  return { text: await engine.ask('write', given), isWhole: true };
}
