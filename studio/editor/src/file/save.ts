// SPDX-License-Identifier: Apache-2.0
// The text of the file that keys are saved in.
import type { Key, Original, StudioDocument } from '../document/document';
import { sameChoice, sameContent, sameKey } from '../document/same';
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

const namesOf = (keys: readonly Key[]): string[] => Object.keys(keys[0]?.own ?? {});

const without = (keys: readonly Key[], names: readonly string[]): readonly Key[] =>
  names.length === 0 ? keys : keys.map((key) => ({ ...key, own: Object.fromEntries(Object.entries(key.own).filter(([name]) => !names.includes(name))) }));

/** Whether each key that is there now had these very values when it was opened. */
function areUntouched(keys: readonly Key[], opened: readonly Key[], name: string): boolean {
  return keys.length === opened.length && keys.every((key, i) => key.row === opened[i].row && Object.is(key.own[name], opened[i].own[name]));
}

/**
 * Names that columns and keys do not share: columns that a setting of the method stands above, which stay as they are; and values that keys
 * have from a list in the method's text, which need no column until they are changed or the text is.
 */
function apart(before: readonly Key[], keys: readonly Key[], opened: readonly Key[], isSameChoice: boolean): { columns: string[]; values: string[] } {
  const [inFile, atFirst, now] = [before, opened, keys].map(namesOf);
  return {
    columns: inFile.filter((name) => !atFirst.includes(name) && !now.includes(name)),
    values: !isSameChoice ? [] : atFirst.filter((name) => !inFile.includes(name) && now.includes(name) && areUntouched(keys, opened, name)),
  };
}

const areSame = (some: readonly Key[], others: readonly Key[]): boolean => some.length === others.length && some.every((key, i) => sameKey(key, others[i]));

/**
 * The rows of the file with what was changed, where it is a simple one; those of any file where no key was. Null where there are none, or the
 * library reads something else out of them.
 */
async function changedRows(original: Original, document: StudioDocument, engine: Engine, opened: StudioDocument): Promise<string | null> {
  const { name } = original;
  try {
    const read = await engine.ask('read', { text: original.text, name });
    const isSameChoice = sameChoice(opened.first, document.first);
    const { columns, values } = apart(read, document.keys, opened.keys, isSameChoice);
    const [before, keys] = [without(read, columns), without(document.keys, values)];
    const hasColumns = namesOf(keys).every((own) => namesOf(before).includes(own));
    const rows = hasColumns && areSame(document.keys, opened.keys) ? original.text : composed(original, before, keys);
    if (rows === null) return null;
    const text = isSameChoice && hasColumns ? rows : withRecipe(rows, document.first);
    return sameKeys(without(await engine.ask('read', { text, name }), columns), keys) ? text : null;
  } catch {
    return null; // what cannot be read is written anew
  }
}

/** `opened`: the document as it was opened. The comment that names a method is left as it is while A is. */
export async function savedText(original: Original, document: StudioDocument, engine: Engine, opened: StudioDocument): Promise<Saved> {
  const text = await changedRows(original, document, engine, opened);
  if (text !== null) return { text, isWhole: false };
  const given = { keys: document.keys, epoch: original.epoch, name: original.name, choice: document.first };
  return { text: await engine.ask('write', given), isWhole: true };
}
