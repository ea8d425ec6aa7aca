// SPDX-License-Identifier: Apache-2.0
// What the user has chosen. Views subscribe to it; nothing else holds choices.
import type { Axis } from './motion';
import { firstShown, keysOf, report, secondShown, shownMethods, timeEnd, timeStart, type BodyShape } from './report';

export interface State {
  first: string | null; // names of methods
  second: string | null;
  time: number;
  window: [from: number, to: number]; // the stretch of time that the plots show
  playing: boolean;
  speed: number; // seconds of the motion per second
  axis: Axis;
  body: BodyShape;
  place: 'follow' | 'path' | 'fixed';
  components: boolean;
  theme: 'light' | 'dark';
}

const hasPositions = shownMethods.some((method) => keysOf(method).p.length > 0 && method.samples.p.length > 0);
const darkDisplay = matchMedia('(prefers-color-scheme: dark)');

let state: State = {
  first: firstShown,
  second: secondShown,
  time: timeStart,
  window: [timeStart, timeEnd],
  playing: false,
  speed: 1,
  axis: 'x',
  body: report.body,
  place: hasPositions ? 'follow' : 'fixed',
  components: true,
  theme: darkDisplay.matches ? 'dark' : 'light',
};

type Field = keyof State;
const subscribers: { fields: Field[]; update: (state: State) => void }[] = [];

export const canFollowPath = hasPositions;
export const current = (): Readonly<State> => state;

/** Calls the update now, and again when one of the fields changes. */
export function subscribe(fields: Field[], update: (state: State) => void): void {
  subscribers.push({ fields, update });
  update(state);
}

export function choose(changes: Partial<State>): void {
  const changed = (Object.keys(changes) as Field[]).filter((field) => changes[field] !== state[field]);
  if (changed.length === 0) return;
  state = { ...state, ...changes };
  for (const { fields, update } of subscribers) if (fields.some((field) => changed.includes(field))) update(state);
}

export const moveTo = (time: number) => choose({ time: Math.min(Math.max(time, timeStart), timeEnd) });

darkDisplay.addEventListener('change', ({ matches }) => choose({ theme: matches ? 'dark' : 'light' }));
