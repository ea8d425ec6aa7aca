// SPDX-License-Identifier: Apache-2.0
import { badArgument, optionsOf, shown } from './errors.js';

/** A setting of a method: a number, one for each key, a word, or three numbers of a rate. `closed: true` makes a loop. */
export type Setting = number | string | boolean | ArrayLike<number> | undefined;
/** By the names of docs/families, in either way of writing: `startRate` is `start_rate`. */
export type Settings = Record<string, Setting>;

const valueOf = (name: string, value: Exclude<Setting, boolean | undefined>): string => {
  let text = '';
  try {
    text = typeof value === 'object' && value ? Array.from(value).join(',') : String(value);
  } catch {
    // A list of symbols, or one that claims to be endless.
  }
  if (!text || value === null || /[:=]/.test(text + name)) throw badArgument(name, `found '${text}', wanted a word or numbers`);
  return text;
};

/** The text of a method, as the library reads it: `timed-c2:tension=0.5,1,0.5:closed`. */
export const methodText = (method: string, settings: Settings): string => {
  if (typeof method !== 'string') throw badArgument('method', `found ${shown(method)}, wanted its name, such as 'auto'`);
  const pieces = Object.entries(optionsOf('settings', settings)).map(([key, value]) => {
    const name = key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
    return value === undefined || value === false ? '' : value === true ? `:${name}` : `:${name}=${valueOf(key, value)}`;
  });
  return method + pieces.join('');
};
