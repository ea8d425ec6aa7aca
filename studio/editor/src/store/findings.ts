// SPDX-License-Identifier: Apache-2.0
// What is odd about the curve: where it turns much farther than its keys, and where it jumps that would be smooth at other times of the keys.
import { angleBetween } from 'orispline-viewer/motion/quaternion';
import type { Key } from '../document/document';
import type { MethodInfo, Samples } from '../engine/protocol';
import type { State } from './store';

/** Turns are in degrees. */
export interface Findings {
  readonly keys: readonly Key[];
  readonly turn: number; // of the curve in all
  readonly need: number; // of its keys: the sum of the shortest ways
  readonly spun: readonly number[]; // spans, by the index of their first key, in which it turns much farther than the keys
  readonly jumps: readonly number[]; // indices of keys at which less is smooth than the method promises on even times
}

const muchFarther = 2; // than the keys, in a span and in all
const turnedOver = 180; // [deg] beside the turn of the keys: so far no curve goes that only overshoots
const worthSaying = 45; // [deg] where it goes much farther in all; as `overturned_span` of the library has it

const degrees = 180 / Math.PI;

/** How far the curve turns between two keys each [deg]. */
export function turnsBetween(keys: readonly Key[], { t, w }: Pick<Samples, 't' | 'w'>): number[] {
  const turns = new Array<number>(Math.max(keys.length - 1, 0)).fill(0);
  const rate = (i: number) => Math.hypot(w[3 * i], w[3 * i + 1], w[3 * i + 2]);
  let span = 0;
  for (let i = 1; i < t.length; ++i) {
    while (span + 2 < keys.length && t[i - 1] >= keys[span + 1].t) ++span;
    turns[span] += ((rate(i - 1) + rate(i)) / 2) * (t[i] - t[i - 1]) * degrees;
  }
  return turns;
}

const stepsOf = (keys: readonly Key[]): number[] => keys.slice(1).map(({ q }, i) => angleBetween([...keys[i].q], [...q]));
const sum = (numbers: readonly number[]): number => numbers.reduce((all, number) => all + number, 0);

/** Of the curve of a method through keys, as it is drawn. */
export function findingsOf(keys: readonly Key[], samples: Samples, { interpolates, continuity_uniform, continuity_uneven }: MethodInfo): Findings {
  const [turns, steps] = [turnsBetween(keys, samples), stepsOf(keys)];
  const [turn, need] = [sum(turns), sum(steps)];
  const least = turn > muchFarther * need ? worthSaying : turnedOver;
  const spun = steps.flatMap((step, i) => (interpolates && turns[i] > Math.max(muchFarther * step, step + least) ? i : []));
  const isForEven = continuity_uneven < continuity_uniform;
  const jumps = keys.flatMap((_, i) => (isForEven && samples.orders[i] < continuity_uniform ? i : []));
  return { keys, turn, need, spun, jumps };
}

let last: { curves: State['curves']; keys: readonly Key[]; method: string; found: Findings } | null = null;

/** Of the curve as it is drawn, and the keys that it was drawn of; null where there is none. Found once for all who ask. */
export function findingsIn({ curves, curvesOf }: Readonly<State>, methods: readonly MethodInfo[]): Findings | null {
  const drawn = curves?.first;
  const method = methods.find(({ name }) => name === curvesOf?.first.method);
  if (!drawn || 'trouble' in drawn || !method || !curvesOf) return null;
  const { keys } = curvesOf;
  if (last?.curves !== curves || last.keys !== keys || last.method !== method.name) last = { curves, keys, method: method.name, found: findingsOf(keys, drawn, method) };
  return last.found;
}
