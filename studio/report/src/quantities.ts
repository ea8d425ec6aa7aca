// SPDX-License-Identifier: Apache-2.0
// What the plots show: each quantity as lines over the times of the methods that are shown.
import { anglesApart, anglesFromStart, component, magnitudes } from './motion';
import { keysOf, methodNamed, report, shownMethods, type Band, type Path, type Samples } from './report';
import type { State } from './state';
import type { Colours } from './theme';

export interface Line {
  label: string;
  colour: string;
  width: number;
  dashes?: number[];
  t: number[];
  values: (number | null)[];
}

/** Points of the report's marks. */
export interface Points {
  t: number[];
  values: (number | null)[];
}

/** A band in the colour of its method. */
export interface PlacedBand extends Band {
  place: 'first' | 'second';
}

export interface Quantity {
  id: string;
  title: string;
  unit: string;
  limit?: number; // in that unit
  limitLabel?: string;
  keys: (state: State) => number[]; // times that are marked
  lines: (state: State, colours: Colours) => Line[];
  marks?: Points;
  band?: (state: State) => PlacedBand | undefined;
}

type Rate = 'w' | 'a' | 'j' | 'torque';

type ValuesOf = (samples: Samples) => (number | null)[];

/** The unit that the report wants a quantity in; its size is that in the page's own unit. */
const unitOf = (id: string, own: string) => report.units[id] ?? { unit: own, size: 1 };

/** Values of the page's own unit in the one that is shown. */
const inUnitOf = (id: string, values: (number | null)[]) => {
  const { size } = unitOf(id, '');
  return size === 1 ? values : values.map((value) => (value === null ? null : value / size));
};

const limitOf = (id: string) => (id in report.limits ? report.limits[id] / unitOf(id, '').size : undefined);

/** That of the first method, else of the second. */
const bandOf = (id: string) => (state: State) => {
  for (const place of ['first', 'second'] as const) {
    const band = methodNamed(state[place])?.bands?.[id];
    if (band) return { ...band, place, low: inUnitOf(id, band.low), high: inUnitOf(id, band.high) };
  }
  return undefined;
};

/** Those of the first method. */
const keys = (state: State) => keysOf(methodNamed(state.first)).t;

const remembered = new WeakMap<object, Map<string, (number | null)[]>>();

/** Values of samples, computed once. */
function valuesOnce<Of extends object>(samples: Of, id: string, compute: (samples: Of) => (number | null)[]): (number | null)[] {
  const byId = remembered.get(samples) ?? new Map<string, (number | null)[]>();
  remembered.set(samples, byId);
  if (!byId.has(id)) byId.set(id, compute(samples));
  return byId.get(id)!;
}

/** One line for each of the two methods, the first on top. */
function ofBoth(state: State, colours: Colours, id: string, valuesOf: ValuesOf, timesOf = (samples: Samples) => samples.t): Line[] {
  const chosen = [
    { method: state.second === state.first ? undefined : methodNamed(state.second), colour: colours.second, width: 1.5 },
    { method: methodNamed(state.first), colour: colours.first, width: 2 },
  ];
  return chosen.flatMap(({ method, colour, width }) =>
    method ? [{ label: method.name, colour, width, t: timesOf(method.samples), values: valuesOnce(method.samples, id, valuesOf) }] : [],
  );
}

/** The body components of the first method. */
function components(state: State, colours: Colours, id: Rate): Line[] {
  const method = methodNamed(state.first);
  if (!state.components || !method) return [];
  return (['x', 'y', 'z'] as const).map((axis, k) => ({
    label: axis,
    colour: colours[axis],
    width: 1,
    t: method.samples.t,
    values: valuesOnce(method.samples, id + axis, (samples) => inUnitOf(id, component(samples[id], k))),
  }));
}

function rate(id: Rate, title: string, ownUnit: string): Quantity {
  const lines = (state: State, colours: Colours) => [
    ...components(state, colours, id),
    ...ofBoth(state, colours, id, (samples) => inUnitOf(id, magnitudes(samples[id]))),
  ];
  return { id, title, unit: unitOf(id, ownUnit).unit, limit: limitOf(id), keys, lines, band: bandOf(id) };
}

function referenceAngle(reference: Path | null, colours: Colours): Line[] {
  if (!reference || reference.t.length === 0) return [];
  const values = valuesOnce(reference, 'angle', anglesFromStart);
  return [{ label: 'reference', colour: colours.reference, width: 3, t: reference.t, values }];
}

const { marks } = report;

const angle: Quantity = {
  id: 'angle',
  title: 'Angle from start',
  unit: 'deg',
  keys,
  lines: (state, colours) => [...referenceAngle(report.reference, colours), ...ofBoth(state, colours, 'angle', anglesFromStart)],
  band: bandOf('angle'),
};

const error: Quantity = {
  id: 'error',
  title: 'Error to the reference',
  unit: unitOf('error', 'deg').unit,
  limit: limitOf('error'),
  keys,
  lines: (state, colours) =>
    ofBoth(state, colours, 'error', (samples) => inUnitOf('error', samples.error_deg), (samples) => (samples.error_t.length > 0 ? samples.error_t : samples.t)).filter(
      ({ values }) => values.length > 0,
    ),
  marks: marks ? { t: marks.t, values: inUnitOf('error', marks.error_deg) } : undefined,
  band: bandOf('error'),
};

const apart: Quantity = {
  id: 'apart',
  title: 'Angle between the two methods',
  unit: 'deg',
  keys,
  lines: (state, colours) => {
    const [first, second] = [methodNamed(state.first), methodNamed(state.second)];
    if (!first || !second || first === second) return [];
    const { t } = first.samples;
    return [{ label: `${first.name}, ${second.name}`, colour: colours.ink, width: 1.5, t, values: anglesApart(first.samples, second.samples) }];
  },
};

const hasTorques = shownMethods.some((method) => method.samples.torque.length > 0);
const hasErrors = shownMethods.some((method) => method.samples.error_deg.length > 0);

export const quantities: Quantity[] = [
  angle,
  ...(hasErrors ? [error] : []),
  rate('w', 'Angular velocity |ω|', 'rad/s'),
  rate('a', 'Angular acceleration |α|', 'rad/s²'),
  rate('j', 'Angular jerk', 'rad/s³'),
  ...(hasTorques ? [rate('torque', 'Torque', 'N m')] : []),
  apart,
];
