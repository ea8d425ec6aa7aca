// SPDX-License-Identifier: Apache-2.0
// What is plotted of methods: each quantity as lines over the times of those that are shown.
import type { Numbers } from '../data/numbers';
import { lazily, once } from '../data/once';
import type { Method, Path, Samples } from '../data/report';
import { typeset } from '../look/number';
import { widths, wordsOf, type Colours } from '../look/theme';
import { angleApartAt, angleFromStartAt, anglesApart, anglesFromStart, chordTolerance } from '../motion/lines';
import type { State, Store } from '../store/store';
import { brokenAfter, straight, type Course, type Line, type Quantity } from './quantity';

const unmeasured = 100; // intervals between samples: a recording has a hole there

type Rate = 'w' | 'a' | 'j' | 'torque';
type Drawn = Pick<Line, 'course' | 'valueAt'>;

const component = (vectors: Numbers, k: number) => Float64Array.from({ length: vectors.length / 3 }, (_, i) => vectors[3 * i + k]);
const magnitudes = (vectors: Numbers) =>
  Float64Array.from({ length: vectors.length / 3 }, (_, i) => Math.hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]));

/** The quantities of one report. What is drawn of a method is computed once. */
class Quantities {
  constructor(private readonly store: Store) {}

  /** The unit that the report wants a quantity in; its size is that in the page's own unit. */
  private unitOf = (id: string, own: string) => this.store.report.units[id] ?? { unit: own, size: 1 };

  /** Values of the page's own unit in the one that is shown. */
  private inUnitOf = (id: string, values: Numbers): Numbers => {
    const { size } = this.unitOf(id, '');
    return size === 1 ? values : values.map((value) => value / size);
  };

  private limitOf = (id: string) => (id in this.store.report.limits ? this.store.report.limits[id] / this.unitOf(id, '').size : undefined);

  /** That of the first method, else of the second. */
  private bandOf = (id: string) => (state: State) => {
    for (const place of ['first', 'second'] as const) {
      const band = this.store.methodNamed(state[place])?.bands[id];
      if (band) return { ...band, place, low: this.inUnitOf(id, band.low), high: this.inUnitOf(id, band.high) };
    }
    return undefined;
  };

  /** Those of the first method. */
  private keys = (state: State) => this.store.keysOf(this.store.methodNamed(state.first)).t;

  /** One line for each of the two methods, the first on top. */
  private ofBoth(state: State, colours: Colours, drawn: (samples: Samples) => Drawn): Line[] {
    const chosen = [
      { method: state.second === state.first ? undefined : this.store.methodNamed(state.second), colour: colours.second, width: widths.second, yields: true },
      { method: this.store.methodNamed(state.first), colour: colours.first, width: widths.first, yields: false },
    ];
    return chosen.flatMap(({ method, ...look }) => (method ? [{ label: method.name, ...look, ...drawn(method.samples) }] : []));
  }

  rate(id: Rate, word: 'rate' | 'acceleration' | 'jerk' | 'torque'): Quantity {
    const { title, unit } = wordsOf(word);
    const axes = (['x', 'y', 'z'] as const).map((axis, k) => ({ axis, valuesOf: once((samples: Samples) => this.inUnitOf(id, component(samples[id], k))) }));
    const size = once((samples: Samples): Course => ({ t: samples.t, values: this.inUnitOf(id, magnitudes(samples[id])) }));
    /** The body components of the first method. */
    const components = ({ first, components }: State, colours: Colours): Line[] => {
      const method = this.store.methodNamed(first);
      if (!components || !method) return [];
      return axes.map(({ axis, valuesOf }) => ({ label: axis, colour: colours[axis], width: widths.component, ...straight(() => ({ t: method.samples.t, values: valuesOf(method.samples) })) }));
    };
    return {
      id,
      title,
      unit: typeset(this.unitOf(id, unit).unit),
      limit: this.limitOf(id),
      keys: this.keys,
      lines: (state, colours) => [...components(state, colours), ...this.ofBoth(state, colours, (samples) => straight(() => size(samples)))],
      band: this.bandOf(id),
    };
  }

  angle(): Quantity {
    const angles = once((path: Path): Drawn => ({ course: lazily(() => anglesFromStart(path)), valueAt: angleFromStartAt(path) }));
    const grey = (colours: Colours): Line[] => {
      const { reference } = this.store.report;
      return reference && reference.t.length > 1 ? [{ label: 'reference', colour: colours.reference, width: widths.reference, ...angles(reference) }] : [];
    };
    return {
      id: 'angle',
      ...wordsOf('angle'),
      keys: this.keys,
      lines: (state, colours) => [...grey(colours), ...this.ofBoth(state, colours, angles)],
      band: this.bandOf('angle'),
    };
  }

  error(): Quantity {
    const { marks } = this.store.report;
    const errors = once(({ t, error_t, error_deg }: Samples) => brokenAfter(unmeasured, { t: error_t.length > 0 ? error_t : t, values: this.inUnitOf('error', error_deg) }));
    return {
      id: 'error',
      title: wordsOf('error').title,
      unit: typeset(this.unitOf('error', wordsOf('error').unit).unit),
      limit: this.limitOf('error'),
      keys: this.keys,
      lines: (state, colours) => this.ofBoth(state, colours, (samples) => straight(() => errors(samples))).filter(({ course }) => course().values.length > 0),
      marks: marks ? { label: marks.label, t: marks.t, values: this.inUnitOf('error', marks.error_deg) } : undefined,
      band: this.bandOf('error'),
    };
  }

  /** Where one of both has a time of its own, they are at the same place at other times: no plot. */
  apart(): Quantity {
    const drawn = (one: Path, other: Path): Drawn => ({ course: lazily(() => anglesApart(one, other)), valueAt: angleApartAt(one, other) });
    const anglesOf = once((first: Method) => once((second: Method) => drawn(first.samples, second.samples)));
    return {
      id: 'apart',
      ...wordsOf('apart'),
      least: 8 * chordTolerance,
      keys: this.keys,
      lines: (state, colours) => {
        const [first, second] = [this.store.methodNamed(state.first), this.store.methodNamed(state.second)];
        if (!first || !second || first === second || first.clock || second.clock) return [];
        return [{ label: `${first.name}, ${second.name}`, colour: colours.ink, width: widths.second, ...anglesOf(first)(second) }];
      },
    };
  }
}

export function methodQuantities(store: Store): Quantity[] {
  const quantities = new Quantities(store);
  const have = (id: 'torque' | 'error_deg') => store.methods.some(({ samples }) => samples[id].length > 0);
  return [
    quantities.angle(),
    ...(have('error_deg') ? [quantities.error()] : []),
    quantities.rate('w', 'rate'),
    quantities.rate('a', 'acceleration'),
    quantities.rate('j', 'jerk'),
    ...(have('torque') ? [quantities.rate('torque', 'torque')] : []),
    quantities.apart(),
  ];
}
