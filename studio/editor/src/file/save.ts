// SPDX-License-Identifier: Apache-2.0
// The text of the file that keys are saved in.
import type { Key, Original, StudioDocument } from '../document/document';
import { alignment } from '../document/keys';
import { sameChoice, sameContent, sameKey } from '../document/same';
import { countedFromFirst } from '../document/times';
import type { Engine } from '../engine/protocol';
import { withRecipe } from './recipe';
import { composed, type Exact } from './rows';

export interface Saved {
  readonly text: string;
  readonly isWhole: boolean; // all rows are written anew, without the comments and further columns that there were
}

const most = 8 * Number.EPSILON; // of a component, between a key and what is read of numbers of another form
const mostOfTime = (span: number): number => 2 * Number.EPSILON * span + 1e-18; // [s] of times such as a third of a second, which are read with 18 decimals

/** Whether a file holds these keys: bit by bit, but for what it states in other forms, which is as near as rounding allows. Its times count from its first key on. */
export function holdsKeys(read: readonly Key[], keys: readonly Key[], exact: Exact): boolean {
  const counted = countedFromFirst(keys), span = counted.at(-1)?.t ?? 0;
  const sign = !exact.orientations && read[0] && counted[0] && alignment(read[0].q, counted[0].q) < 0 ? -1 : 1; // one for all
  const isNear = ({ t, q }: Key, wanted: Key): boolean =>
    (exact.times || Math.abs(t - wanted.t) <= mostOfTime(span)) && (exact.orientations || q.every((number, i) => Math.abs(sign * number - wanted.q[i]) <= most));
  const like = (key: Key, wanted: Key): Key => ({ ...key, ...(exact.times ? {} : { t: wanted.t }), ...(exact.orientations ? {} : { q: wanted.q }) });
  return read.length === keys.length && read.every((key, i) => isNear(key, counted[i]) && sameContent(like(key, counted[i]), counted[i]));
}

const whole: Exact = { orientations: true, times: true };

export const sameKeys = (read: readonly Key[], keys: readonly Key[]): boolean => holdsKeys(read, keys, whole);

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
 * library reads something else out of them, or another method for A.
 */
async function changedRows(original: Original, document: StudioDocument, engine: Engine, opened: StudioDocument): Promise<string | null> {
  const { name, reading } = original, choice = document.first;
  const readOf = (text: string) => engine.ask('read', { text, name, reading });
  const own = document.keys.map((key) => key.own);
  const reopens = (text: string) => engine.ask('reopens', { text, name, reading, choice, own });
  try {
    const read = await readOf(original.text);
    const { columns, values } = apart(read, document.keys, opened.keys, sameChoice(opened.first, choice));
    const [before, keys] = [without(read, columns), without(document.keys, values)];
    const hasColumns = namesOf(keys).every((own) => namesOf(before).includes(own));
    const isAsOpened = hasColumns && areSame(document.keys, opened.keys);
    const rows = isAsOpened ? { text: original.text, exact: whole } : await composed(original, before, keys, engine);
    if (rows === null) return null;
    const text = (await reopens(rows.text)) ? rows.text : withRecipe(rows.text, choice);
    return holdsKeys(without(await readOf(text), columns), keys, rows.exact) && (text === rows.text || (await reopens(text))) ? text : null;
  } catch {
    return null; // what cannot be read is written anew
  }
}

/** `opened`: the document as it was opened. `wholeName`: of the file that all rows are written into where they cannot stay; its name says of which format. */
export async function savedText(original: Original, document: StudioDocument, engine: Engine, opened: StudioDocument, wholeName = original.name): Promise<Saved> {
  const text = await changedRows(original, document, engine, opened);
  if (text !== null) return { text, isWhole: false };
  const given = { keys: document.keys, epoch: original.epoch, name: wholeName, choice: document.first };
  return { text: await engine.ask('write', given), isWhole: true };
}
