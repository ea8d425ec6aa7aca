// SPDX-License-Identifier: Apache-2.0
// A file becomes a document.
import type { KeyInfo, KeyTrack } from 'orispline/key_track';
import type { Choice, Key, Original, StudioDocument } from '../document/document';
import { methodText } from '../document/methodText';
import { plainReading, pointed } from '../document/reading';
import { sameChoice, sameMembers } from '../document/same';
import { choiceOf, perKey } from './choices';
import { curedOnPage, remedyIn } from './cures';
import { sha256 } from './hash';
import { keysIn } from './keys';
import { type Library, used } from './library';
import { mostKeys, type Given, type MethodInfo, type Opened, type Source, type TooMany, type Warning } from './protocol';

/** The text of a file; '' where it is none. */
const textIn = (bytes: Uint8Array): string => {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return '';
  }
};

const originalOf = ({ bytes, name, reading, hash = sha256(bytes) }: Source, { epoch }: KeyInfo): Original => ({ name, text: textIn(bytes), hash, epoch, ...(reading ? { reading } : {}) });

/** The keys of a file as the user has said that it is read. */
export const trackOf = (library: Library, { bytes, name, reading = plainReading }: Source): KeyTrack => library.read(reading.comma ? pointed(textIn(bytes)) : bytes, name, reading.options);

/** What the library warns of, for the page. */
export const warningsFrom = (warnings: readonly { message: string }[]): Warning[] =>
  warnings.map(({ message }) => {
    const remedy = remedyIn(message);
    return { message: curedOnPage(message), ...(remedy ? { remedy } : {}) };
  });

const besideOf = ({ method }: Choice): Choice => ({ method: method === 'slerp' ? 'auto' : 'slerp', settings: {} });

/** With the lists of a choice, one value for each key, as values of the keys; a choice has no setting that keys have values of. */
function documentOf(keys: Key[], first: Choice, second: Choice, methods: readonly MethodInfo[]): StudioDocument {
  const names = perKey(methods, first.method), settings = { ...first.settings };
  let all: Key[] = keys;
  for (const [name, value] of Object.entries(settings)) {
    const values = typeof value === 'string' ? value.split(',').map(Number) : [];
    const isList = names.has(name) && values.length === keys.length;
    if (isList) delete settings[name];
    if (isList) all = all.map((key, k) => ({ ...key, own: { ...key.own, [name]: values[k] } }));
    else all = all.map((key) => ({ ...key, own: Object.fromEntries(Object.entries(key.own).filter(([one]) => one !== name)) }));
  }
  return { version: 1, keys: all, first: { method: first.method, settings }, second };
}

export class Opening {
  private readonly library: Library;
  private readonly methods: readonly MethodInfo[];

  constructor(library: Library, methods: readonly MethodInfo[]) {
    this.library = library;
    this.methods = methods;
  }

  open(given: Given<'open'>): Opened | TooMany {
    return used(trackOf(this.library, given), (track) => {
      const { info } = track, original = originalOf(given, info);
      if (info.count > mostKeys) return { original, count: info.count, hasPositions: info.columns.some(({ name }) => name === 'positions') };
      const warnings: Warning[] = [], document = this.documentIn(track, given, warnings);
      return { original, document, warnings };
    });
  }

  /** What the page has to say of it goes with the warnings. */
  private documentIn(track: KeyTrack, { method, beside }: Pick<Given<'open'>, 'method' | 'beside'>, warnings: Warning[]): StudioDocument {
    const { info } = track, keys = this.keysIn(track, true);
    warnings.push(...this.warningsOf(info, keys));
    const first = method ? this.choice(method) : this.choiceIn(info, warnings), second = beside ? this.choice(beside) : besideOf(first);
    return documentOf(keys, first, second, this.methods);
  }

  /** Keys that were made of a recording are those of a new file. */
  made(track: KeyTrack, source: Source, said: Warning[]): Opened {
    const { info } = track, name = source.name.replace(/(\.[^.]*)?$/, '_keys.csv'), original = { ...originalOf(source, info), name, text: '' }, first = this.choiceIn(info, said);
    return { original, document: documentOf(this.keysIn(track, false), first, besideOf(first), this.methods), warnings: said };
  }

  reopens({ text, name, reading, choice, own }: Given<'reopens'>): boolean {
    const { first, keys } = used(trackOf(this.library, { bytes: new TextEncoder().encode(text), name, reading }), (track) => this.documentIn(track, {}, []));
    return sameChoice(first, this.settled(choice)) && keys.length === own.length && keys.every((key, k) => sameMembers(key.own, own[k]));
  }

  keysIn(track: KeyTrack, isOriginal: boolean): Key[] {
    const names = perKey(this.methods);
    const own = track.info.columns.filter(({ name, width }) => width === 1 && names.has(name)).map(({ name }) => name);
    return keysIn(track, own, isOriginal);
  }

  /** As it is opened again; what the library refuses stays as it is. */
  private settled(choice: Choice): Choice {
    try {
      return this.choice(methodText(choice));
    } catch {
      return choice;
    }
  }

  private choice(text: string): Choice {
    return choiceOf(this.library.methodText(text));
  }

  /** That which the file is for; one of its own cannot be had here. */
  private choiceIn({ method }: KeyInfo, warnings: Warning[]): Choice {
    try {
      return this.choice(method ?? 'auto');
    } catch (reason) {
      warnings.push({ message: `The file is for ${method}, which cannot be had here: ${(reason as Error).message}.` });
      return this.choice('auto');
    }
  }

  private warningsOf({ warnings, count, columns }: KeyInfo, keys: readonly Key[]): Warning[] {
    const said = warningsFrom((warnings ?? []) as { message: string }[]), say = (message: string) => said.push({ message });
    if (count === 1) say('The file has one key, and so the body rests; insert another key to see it turn.');
    if (columns.some(({ name }) => name.startsWith('inner_'))) say('The file has inner quaternions, which the studio does not use.');
    if (keys.some(({ q }, k) => k > 0 && keys[k - 1].q.reduce((sum, x, i) => sum + x * q[i], 0) < 0))
      say('The signs of the quaternions in the file say which way round the body turns; the studio turns it the short way.');
    return said;
  }
}
