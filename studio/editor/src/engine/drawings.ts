// SPDX-License-Identifier: Apache-2.0
// Curves of both choices, of which those are drawn that have changed.
import type { KeyData } from 'orispline/keys';
import type { Settings } from 'orispline/method';
import type { Choice, Which } from '../document/document';
import { settingsOf } from './choices';
import { countedOf } from './counted';
import { dataOf } from './keys';
import { type Library, used } from './library';
import type { Drawn, Given, MethodInfo } from './protocol';
import { areSame } from './same';
import { drawnSamples } from './samples';
import { troubleOf } from './trouble';

/** A curve as it is drawn, or that it is the last one that was told. */
export type Redrawn = Record<Which, Drawn | 'same'>;

const areSameKeys = (a: KeyData, b: KeyData): boolean => {
  const names = Object.keys(a) as (keyof KeyData)[];
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name] || areSame(a[name] as Float64Array, (b[name] ?? []) as Float64Array));
};

export class Drawings {
  private readonly library: Library;
  private readonly methods: readonly MethodInfo[];
  private readonly told: Partial<Record<Which, string>> = {};
  private data: KeyData | null = null;

  constructor(library: Library, methods: readonly MethodInfo[]) {
    this.library = library;
    this.methods = methods;
  }

  redrawn({ document: { keys: edited, first, second }, count }: Given<'curves'>): Redrawn {
    const { keys, given } = countedOf(edited), data = dataOf(keys), hasMoved = !this.data || !areSameKeys(data, this.data);
    this.data = data;
    const drawn = (which: Which, choice: Choice): Drawn | 'same' => {
      const settings = settingsOf(choice, keys, this.methods), about = JSON.stringify([choice.method, settings, count, edited[0]?.t]);
      if (!hasMoved && this.told[which] === about) return 'same';
      this.told[which] = about;
      const drawing = this.drawn(choice.method, settings, data, count);
      return 'trouble' in drawing ? drawing : { ...drawing, t: given(drawing.t) };
    };
    return { first: drawn('first', first), second: drawn('second', second) };
  }

  private drawn(method: string, settings: Settings, data: KeyData, count: number): Drawn {
    try {
      return used(this.library.curve(method, data, settings), (curve) => drawnSamples(curve, data.times, count));
    } catch (reason) {
      return { trouble: troubleOf(reason) };
    }
  }
}
