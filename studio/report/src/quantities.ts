// SPDX-License-Identifier: Apache-2.0
// What the plots show: each quantity as lines over the times of the methods that are shown.
import { anglesFromStart, component, magnitudes } from './motion';
import { methodNamed, report, shownMethods, type Path, type Samples } from './report';
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

export interface Quantity {
  id: string;
  title: string;
  unit: string;
  lines: (state: State, colours: Colours) => Line[];
}

type ValuesOf = (samples: Samples) => (number | null)[];

const remembered = new WeakMap<object, Map<string, (number | null)[]>>();

/** Values of samples, computed once. */
function valuesOnce<Of extends object>(samples: Of, id: string, compute: (samples: Of) => (number | null)[]): (number | null)[] {
  const byId = remembered.get(samples) ?? new Map<string, (number | null)[]>();
  remembered.set(samples, byId);
  if (!byId.has(id)) byId.set(id, compute(samples));
  return byId.get(id)!;
}

/** One line for each of the two methods. */
function ofBoth(state: State, colours: Colours, id: string, valuesOf: ValuesOf): Line[] {
  const chosen = [
    { method: methodNamed(state.first), colour: colours.first, width: 2 },
    { method: state.second === state.first ? undefined : methodNamed(state.second), colour: colours.second, width: 1.5 },
  ];
  return chosen.flatMap(({ method, colour, width }) =>
    method ? [{ label: method.name, colour, width, t: method.samples.t, values: valuesOnce(method.samples, id, valuesOf) }] : [],
  );
}

/** The body components of the first method. */
function components(state: State, colours: Colours, id: 'w' | 'a' | 'j'): Line[] {
  const method = methodNamed(state.first);
  if (!state.components || !method) return [];
  return (['x', 'y', 'z'] as const).map((axis, k) => ({
    label: axis,
    colour: colours[axis],
    width: 1,
    t: method.samples.t,
    values: valuesOnce(method.samples, id + axis, (samples) => component(samples[id], k)),
  }));
}

function rate(id: 'w' | 'a' | 'j', title: string, unit: string): Quantity {
  const lines = (state: State, colours: Colours) => [
    ...components(state, colours, id),
    ...ofBoth(state, colours, id, (samples) => magnitudes(samples[id])),
  ];
  return { id, title, unit, lines };
}

function referenceAngle(reference: Path | null, colours: Colours): Line[] {
  if (!reference || reference.t.length === 0) return [];
  const values = valuesOnce(reference, 'angle', anglesFromStart);
  return [{ label: 'reference', colour: colours.reference, width: 3, t: reference.t, values }];
}

const angle: Quantity = {
  id: 'angle',
  title: 'Angle from start',
  unit: 'deg',
  lines: (state, colours) => [...referenceAngle(report.reference, colours), ...ofBoth(state, colours, 'angle', anglesFromStart)],
};

const error: Quantity = {
  id: 'error',
  title: 'Error to the reference',
  unit: 'deg',
  lines: (state, colours) => ofBoth(state, colours, 'error', (samples) => samples.error_deg),
};

const hasErrors = shownMethods.some((method) => method.samples.error_deg.length > 0);

export const quantities: Quantity[] = [
  angle,
  ...(hasErrors ? [error] : []),
  rate('w', 'Angular velocity |ω|', 'rad/s'),
  rate('a', 'Angular acceleration |α|', 'rad/s²'),
  rate('j', 'Angular jerk', 'rad/s³'),
];
