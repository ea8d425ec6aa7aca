// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { badArgument, optionsOf, shown } from './errors.js';

/** Options by their names, as the command has them: `{ tolerance: '0.1deg', values: true }`. Those that are undefined are not stated. */
export type Options = Record<string, string | number | boolean | undefined>;

/** Texts in the memory of the library, for the time of some work. */
export const withTexts = <Result>(engine: Engine, texts: string[], work: (list: Address, count: number) => Result): Result => {
  const withOthers = (k: number, places: number[]): Result =>
    k < texts.length ? engine.withText(texts[k], (at) => withOthers(k + 1, [...places, at])) : engine.withWords(places, (list) => work(list, places.length));
  return withOthers(0, []);
};

/** Options as texts `name=value`, for the time of some work. */
export const withOptions = <Result>(engine: Engine, options: Options, work: (list: Address, count: number) => Result): Result => {
  const texts = Object.entries(optionsOf('options', options)).flatMap(([name, value]) => {
    if (value === undefined) return [];
    if (!['string', 'number', 'boolean'].includes(typeof value)) throw badArgument(name, `found ${shown(value)}, wanted a text, a number or a flag`);
    return [`${name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`)}=${value}`];
  });
  return withTexts(engine, texts, work);
};
