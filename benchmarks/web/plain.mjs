// SPDX-License-Identifier: Apache-2.0
// The data of a report with plain lists of numbers, as pages had them before their data were typed.
import { moduleOf } from '../../studio/viewer/tests/built.mjs';

const { numbersOf } = await moduleOf('data/numbers.ts');

const isTyped = (value) => ['f2', 'f4', 'f8', 'u4'].some((form) => typeof value[form] === 'string');

/** The same document; JSON of it, in which NaN is null, is what a page of data version 1 reads. */
export function plain(document) {
  const walk = (value) => {
    if (Array.isArray(value)) return value.map(walk);
    if (value === null || typeof value !== 'object') return value;
    if (isTyped(value)) return Array.from(numbersOf(value));
    return Object.fromEntries(Object.entries(value).map(([name, member]) => [name, walk(member)]));
  };
  const made = walk(document);
  for (const { samples } of made.methods ?? [])
    for (const list of ['t', 'error_t']) if (samples[list]?.like !== undefined) samples[list] = made.methods[samples[list].like].samples[list];
  delete made.data;
  return made;
}
