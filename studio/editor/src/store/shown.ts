// SPDX-License-Identifier: Apache-2.0
// Both curves as the viewer's report of them. A choice that is refused keeps the curve that it had last.
import { reportOf, type Keys, type Method, type Report } from 'orispline-viewer/data/report';
import { type Choice, type Key, type StudioDocument, type Which } from '../document/document';
import { methodText } from '../document/methodText';
import type { Curves, Samples } from '../engine/protocol';

const none = new Float64Array();

const words: Record<Which, string> = { first: 'Curve', second: 'beside' };

export const nameOf = (which: Which, choice: Choice): string => `${words[which]} ${methodText(choice)}`;

const keysOf = (keys: readonly Key[]): Keys => ({
  t: Float64Array.from(keys, ({ t }) => t),
  q: Float64Array.from(keys.flatMap(({ q }) => q)),
  p: Float64Array.from(keys.flatMap(({ p }) => p ?? [])),
});

const methodOf = (name: string, { t, q, w, a, j, p }: Samples, keys: Keys): Method => ({
  name,
  continuity: '',
  failure: '',
  measures: {},
  samples: { t, q, w, a, j, p, torque: none, error_t: none, error_deg: none, straight: false, exactness_deg: null },
  keys,
  bands: {},
  clock: null,
});

export class Shown {
  private readonly last: Partial<Record<Which, Method>> = {};

  report(document: StudioDocument, curves: Curves): Report {
    const keys = keysOf(document.keys);
    const [first, second] = (['first', 'second'] as const).map((which) => this.method(which, document, curves, keys));
    return reportOf({ keys, methods: [first, second].filter((method) => method !== undefined), first: first?.name ?? '', second: second?.name ?? '' });
  }

  private method(which: Which, document: StudioDocument, curves: Curves, keys: Keys): Method | undefined {
    const drawn = curves[which];
    const last = this.last[which];
    if ('trouble' in drawn) return last && { ...last, keys, failure: drawn.trouble.message };
    return (this.last[which] = methodOf(nameOf(which, document[which]), drawn, keys));
  }
}
