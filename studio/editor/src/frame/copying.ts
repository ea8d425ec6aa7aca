// SPDX-License-Identifier: Apache-2.0
// What makes the same motion elsewhere, as text.
import { copiedCode, languagesFor, type Language } from '../file/code';
import type { Studio } from '../store/studio';
import { showText } from './dialog';
import type { Item } from './popup';

/** Samples at even times, as many as are plotted at least. */
export const sampleCount = 600;

const titles: Record<Language, string> = { command: 'Command', 'C++': 'C++', Python: 'Python', JavaScript: 'JavaScript' };

export function copiesOf({ store, methods, original }: Studio, place: () => HTMLElement, tell: (sentence: string) => void): Item[] {
  const show = (language: Language) => {
    const { keys, first: choice } = store.current().document;
    const method = methods.find(({ name }) => name === choice.method)!;
    const text = copiedCode(language, { name: original.name, keys, choice, method, count: sampleCount, reading: original.reading });
    const needs = language !== 'JavaScript' && !store.current().isSaved ? ' (save the keys first)' : '';
    void showText(place(), `${titles[language]} for the curve${needs}`, text, tell);
  };
  return languagesFor(original.reading).map((language) => ({ label: titles[language], chosen: () => show(language) }));
}
