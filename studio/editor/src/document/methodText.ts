// SPDX-License-Identifier: Apache-2.0
// A method with its settings as the library reads it: `timed-c2:tension=0.6:ends=natural:closed`.
import type { Choice } from './document';
import { numberText } from './decimal';

export function methodText({ method, settings }: Choice): string {
  const pieces = Object.entries(settings).map(([name, value]) => {
    if (typeof value === 'boolean') return value ? `:${name}` : '';
    return `:${name}=${typeof value === 'number' ? numberText(value) : value}`;
  });
  return method + pieces.join('');
}

/** With numbers in one form, and settings in one order. */
function settled(text: string): string {
  const [name, ...pieces] = text.split(':');
  const plain = pieces.map((piece) => piece.replace(/[^=,]+/g, (word) => (Number.isNaN(Number(word)) ? word : numberText(Number(word)))));
  return [name, ...plain.sort()].join(':');
}

/** Whether two texts are one method. */
export const sameMethod = (some: string, other: string): boolean => settled(some) === settled(other);
