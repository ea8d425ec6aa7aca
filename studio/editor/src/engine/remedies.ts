// SPDX-License-Identifier: Apache-2.0
// Other methods for keys with which one turns too far, or jumps: all that the library has are tried, and what they do is measured.
import type { WholeCurve } from 'orispline/whole_curve';
import type { Choice, Key, Setting } from '../document/document';
import { settingsOf } from './choices';
import { dataOf } from './keys';
import { type Library, used } from './library';
import type { MethodInfo, Remedy } from './protocol';
import { drawnSamples } from './samples';

const countFor = (keys: number): number => Math.max(600, 8 * keys); // samples of a curve that is measured
const nearTurn = 1.5; // of what the keys need: a curve that turns no farther is calm
const muchLess = 0.5; // of the turn that is to be cured, where no curve is calm
const perSpan = 8; // places between two keys at which curves are compared

interface Measured {
  turn: number; // [rad]
  order: number; // no rate up to it jumps at a key
}

function measured(curve: WholeCurve, times: ArrayLike<number>): Measured {
  const { t, w, orders } = drawnSamples(curve, times, countFor(times.length));
  const rate = (i: number) => Math.hypot(w[3 * i], w[3 * i + 1], w[3 * i + 2]);
  let turn = 0;
  for (let i = 1; i < t.length; ++i) turn += ((rate(i - 1) + rate(i)) / 2) * (t[i] - t[i - 1]);
  return { turn, order: Math.min(...orders) };
}

/** Between two orientations in lists of them [rad]; both signs are one. */
function apart(a: ArrayLike<number>, b: ArrayLike<number>, i: number): number {
  let [minus, plus] = [0, 0];
  for (let k = 4 * i; k < 4 * i + 4; ++k) {
    minus += (a[k] - b[k]) ** 2;
    plus += (a[k] + b[k]) ** 2;
  }
  return 4 * Math.atan2(Math.sqrt(Math.min(minus, plus)), Math.sqrt(Math.max(minus, plus)));
}

const isLocal = ({ support_keys }: MethodInfo): boolean => support_keys !== null; // what takes all keys takes its time, too
const perKeyOf = ({ parameters }: MethodInfo): string[] => parameters.filter(({ per_key }) => per_key).map(({ name }) => name);

export class Remedies {
  private readonly library: Library;
  private readonly methods: readonly MethodInfo[];

  constructor(library: Library, methods: readonly MethodInfo[]) {
    this.library = library;
    this.methods = methods;
  }

  /**
   * The calmest: of the methods whose curves turn little farther than the keys those that are as smooth as that of the choice, or else the
   * smoothest, and of them that which turns least. `need`: how far the keys turn [rad].
   */
  calmest(keys: readonly Key[], choice: Choice, need: number): Remedy | null {
    const now = this.measured(keys, choice);
    if (!now) return null;
    const found = this.methods
      .filter((method) => method.interpolates && isLocal(method) && method.name !== choice.method)
      .flatMap((method) => {
        const other = { method: method.name, settings: this.kept(choice, method, ['closed', 'period']) };
        const made = this.measured(keys, other);
        return made ? { choice: other, own: [], ...made } : [];
      });
    const calm = found.filter(({ turn }) => turn <= nearTurn * need);
    const rank = ({ order }: Measured) => Math.min(order, now.order);
    const best = calm.length > 0 ? calm.sort((a, b) => rank(b) - rank(a) || a.turn - b.turn)[0] : found.sort((a, b) => a.turn - b.turn)[0];
    return best && (calm.length > 0 || best.turn < muchLess * now.turn) ? { ...best, apart: null } : null;
  }

  /**
   * Of a method that keeps its promise on even times only, that which keeps it on any: with all its values at keys, as smooth at these, and at
   * even times nearest to it.
   */
  ofAnyTimes(keys: readonly Key[], choice: Choice): Remedy | null {
    const method = this.methods.find(({ name }) => name === choice.method)!;
    const wanted = method.continuity_uniform, values = perKeyOf(method);
    const even = keys.map((key, k) => ({ ...key, t: k })), times = Float64Array.from({ length: perSpan * (keys.length - 1) + 1 }, (_, k) => k / perSpan);
    const before = this.orientations(even, choice, times);
    if (!before) return null;
    const others = this.methods.filter((other) => other.interpolates && isLocal(other) && other.continuity_uneven >= wanted && values.every((name) => perKeyOf(other).includes(name)));
    const found = others.flatMap((other) => this.carried(choice, method, other)).flatMap((remedy) => {
      const changed = withOwn(even, remedy.own), after = this.orientations(changed, remedy.choice, times);
      const made = after && this.measured(withOwn(keys, remedy.own), remedy.choice);
      if (!made || made.order < wanted) return [];
      return { ...remedy, ...made, apart: Array.from(times, (_, i) => apart(before, after, i)).reduce((most, angle) => Math.max(most, angle), 0) };
    });
    return found.sort((a, b) => a.apart - b.apart)[0] ?? null;
  }

  /** Another method with the settings of a choice: as they are, and with further values at keys, such as `tension2`, tied to those that both have. */
  private carried(choice: Choice, method: MethodInfo, other: MethodInfo): Pick<Remedy, 'choice' | 'own'>[] {
    const settings = this.kept(choice, other, [...perKeyOf(other), 'closed', 'period', 'ends', 'start_rate', 'end_rate']);
    const isOpen = settings.closed === undefined && settings.period === undefined;
    if (isOpen && settings.ends === undefined && method.ends[0] !== other.ends[0] && other.ends.includes(method.ends[0])) settings.ends = method.ends[0];
    const values = method.parameters.filter(({ per_key }) => per_key), plain = { choice: { method: other.name, settings }, own: [] };
    const tied = other.parameters.flatMap(({ name, per_key }) => {
      const from = values.find((value) => per_key && value.name !== name && name.startsWith(value.name));
      return from ? { name, from } : [];
    });
    if (tied.length === 0) return [plain];
    const all = Object.fromEntries(tied.map(({ name, from }): [string, Setting] => [name, choice.settings[from.name] ?? from.default]));
    const isOthers = ({ name, default: value }: { name: string; default: number }) => other.parameters.some((one) => one.name === name && one.default === value);
    const usual = Object.fromEntries(values.filter((value) => settings[value.name] === undefined && !isOthers(value)).map(({ name, default: value }) => [name, value]));
    return [plain, { choice: { method: other.name, settings: { ...usual, ...settings, ...all } }, own: tied.map(({ name, from }) => [name, from.name]) }];
  }

  /** Those settings of a choice that another method has too. */
  private kept({ settings }: Choice, method: MethodInfo, names: string[]): Record<string, Setting> {
    const has = (name: string, value: Setting) =>
      ['closed', 'period'].includes(name) ? method.closes
        : name === 'ends' ? String(value).split(',').every((end) => method.ends.includes(end))
          : name.endsWith('_rate') ? method.ends.includes('clamped')
            : true;
    return Object.fromEntries(Object.entries(settings).filter(([name, value]) => names.includes(name) && has(name, value)));
  }

  private measured(keys: readonly Key[], choice: Choice): Measured | null {
    return this.curve(keys, choice, (curve) => measured(curve, keys.map(({ t }) => t)));
  }

  private orientations(keys: readonly Key[], choice: Choice, times: Float64Array): ArrayLike<number> | null {
    return this.curve(keys, choice, (curve) => curve.sample({ times, rates: 0 }).orientations);
  }

  /** What there is to know of a curve; null where there is none. */
  private curve<Result>(keys: readonly Key[], choice: Choice, work: (curve: WholeCurve) => Result): Result | null {
    try {
      return used(this.library.curve(choice.method, dataOf(keys), settingsOf(choice, keys, this.methods)), work);
    } catch {
      return null;
    }
  }
}

/** Keys with values of their own that are those of others of them. */
const withOwn = (keys: readonly Key[], own: Remedy['own']): readonly Key[] =>
  keys.map((key) => ({ ...key, own: { ...key.own, ...Object.fromEntries(own.filter(([, from]) => from in key.own).map(([name, from]) => [name, key.own[from]])) } }));
