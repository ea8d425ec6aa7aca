// SPDX-License-Identifier: Apache-2.0
// What the user has chosen. Views subscribe to it; nothing else holds choices.
import type { Axis } from './motion';
import { clips, firstShown, keysOf, report, secondShown, shownMethods, timeEnd, timeStart, type BodyShape } from './report';

export interface State {
  first: string | null; // names of methods
  second: string | null;
  clip: number; // its place among those of the skeleton
  joint: number;
  magnified: number; // differences of the two motions in space
  time: number;
  extent: [from: number, to: number]; // all that may be shown
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

/** A clip from the start on, or at another time. */
export const withClip = (clip: number, time = clips[clip].start): Partial<State> => {
  const extent: State['extent'] = [clips[clip].start, clips[clip].end];
  return { clip, extent, window: extent, time };
};

let state: State = {
  first: firstShown,
  second: secondShown,
  clip: 0,
  joint: 0,
  magnified: 1,
  time: timeStart,
  extent: [timeStart, timeEnd],
  window: [timeStart, timeEnd],
  playing: false,
  speed: 1,
  axis: 'x',
  body: report.body,
  place: report.skeleton || hasPositions ? 'follow' : 'fixed',
  components: true,
  theme: darkDisplay.matches ? 'dark' : 'light',
  ...(clips.length > 0 ? withClip(0) : {}),
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

export const moveTo = (time: number) => choose({ time: Math.min(Math.max(time, state.extent[0]), state.extent[1]) });

darkDisplay.addEventListener('change', ({ matches }) => choose({ theme: matches ? 'dark' : 'light' }));
