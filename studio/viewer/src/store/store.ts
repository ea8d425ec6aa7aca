// SPDX-License-Identifier: Apache-2.0
// What one viewer shows, and what its user has chosen. Views subscribe to it; nothing else holds choices.
import { hasPositions, hasSamples, type BodyShape, type Clip, type Method, type Report } from '../data/report';
import { Moments } from '../look/moments';
import { coloursOf, type Colours } from '../look/theme';
import type { Axis, Up } from '../motion/quaternion';
import { startingTime } from '../motion/startingTime';

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
  up: Up;
  body: BodyShape;
  place: 'follow' | 'path' | 'fixed';
  components: boolean;
  theme: 'light' | 'dark';
}

type Field = keyof State;
type Update = (state: Readonly<State>) => void;

/** A clip from the start on, or at another time. */
export function withClip(clips: Clip[], clip: number, time = clips[clip].start): Partial<State> {
  const extent: State['extent'] = [clips[clip].start, clips[clip].end];
  return { clip, extent, window: extent, time };
}

/** From the first moment that there is to the last one. */
function extentOf({ keys, skeleton }: Report, methods: Method[]): State['extent'] {
  const clips = skeleton?.clips ?? [];
  const ends = [...methods.map(({ samples }) => samples.t), keys.t, ...clips.map(({ start, end }) => [start, end])].filter(({ length }) => length > 0);
  return [Math.min(...ends.map((t) => t[0])), Math.max(...ends.map((t) => t[t.length - 1]))];
}

/** A report, and what follows from it. */
function dataOf(report: Report) {
  const methods = report.methods.filter(hasSamples);
  const extent = extentOf(report, methods);
  return { report, methods, extent, moments: new Moments(extent), canFollowPath: methods.some(hasPositions) };
}

type Data = ReturnType<typeof dataOf>;

const nameIn = (methods: Method[], name: string | null) => (methods.find((method) => method.name === name) ?? methods[0])?.name ?? null;

/** What is shown until the user chooses: what the report says, else the first of the methods. */
function firstState({ report, methods, extent }: Data, theme: State['theme']): State {
  const first = nameIn(methods, report.first);
  const others = methods.filter(({ name }) => name !== first);
  const second = nameIn(others, report.second);
  const find = (name: string | null) => methods.find((method) => method.name === name);
  const clips = report.skeleton?.clips ?? [];
  return {
    first,
    second,
    clip: 0,
    joint: 0,
    magnified: 1,
    time: startingTime(find(first), find(second), extent[0]),
    extent,
    window: extent,
    playing: false,
    speed: 1,
    axis: 'x',
    up: 'z',
    body: report.body,
    place: report.skeleton || methods.some(hasPositions) ? 'follow' : 'fixed',
    components: true,
    theme,
    ...(clips.length > 0 ? withClip(clips, 0) : {}),
  };
}

/** What a report newly names, else what was chosen where there still is such a method. */
function nameAfter(which: 'first' | 'second', chosen: string | null, before: Data, { report, methods }: Data): string | null {
  const has = (name: string) => methods.some((method) => method.name === name);
  if (report[which] !== before.report[which] && has(report[which])) return report[which];
  if (chosen === null || has(chosen)) return chosen;
  return which === 'first' ? nameIn(methods, report.first) : null;
}

const clamped = (time: number, [from, to]: State['extent']) => Math.min(Math.max(time, from), to);

/** What was the whole stays the whole. */
function windowAfter(window: State['window'], before: State['extent'], after: State['extent']): State['window'] {
  const [from, to] = [clamped(window[0], after), clamped(window[1], after)];
  const isWhole = window[0] === before[0] && window[1] === before[1];
  return isWhole || !(from < to) ? after : [from, to];
}

export class Store {
  private data: Data;
  private state: State;
  private readonly subscribers = new Set<{ fields: Field[]; update: Update }>();
  private readonly endings: (() => void)[] = [];

  constructor(report: Report) {
    this.data = dataOf(report);
    const dark = matchMedia('(prefers-color-scheme: dark)');
    this.state = firstState(this.data, dark.matches ? 'dark' : 'light');
    this.listen(dark, 'change', () => this.choose({ theme: dark.matches ? 'dark' : 'light' }));
  }

  get report(): Report {
    return this.data.report;
  }

  /** Those that have samples. */
  get methods(): Method[] {
    return this.data.methods;
  }

  get moments(): Moments {
    return this.data.moments;
  }

  get canFollowPath(): boolean {
    return this.data.canFollowPath;
  }

  current = (): Readonly<State> => this.state;

  /** Calls the update now, and again when one of the fields changes, until what it returns is called. */
  subscribe = (fields: Field[], update: Update): (() => void) => {
    const subscriber = { fields, update };
    this.subscribers.add(subscriber);
    update(this.state);
    return () => this.subscribers.delete(subscriber);
  };

  choose = (changes: Partial<State>): void => {
    const changed = (Object.keys(changes) as Field[]).filter((field) => changes[field] !== this.state[field]);
    if (changed.length > 0) this.change(changes, changed);
  };

  private change(changes: Partial<State>, told: Field[]): void {
    this.state = { ...this.state, ...changes };
    for (const { fields, update } of this.subscribers) if (fields.some((field) => told.includes(field))) update(this.state);
  }

  /**
   * Shows other keys and other curves through them in all views, which stay. What else a report says, such as its columns, limits and
   * marks, is to be what it was before.
   */
  replace = (report: Report): void => {
    const before = this.data;
    const { first, second, time, window, extent: old } = this.state;
    const after = (this.data = dataOf(report));
    const { extent } = after;
    const changes = { first: nameAfter('first', first, before, after), second: nameAfter('second', second, before, after), extent, window: windowAfter(window, old, extent), time: clamped(time, extent) };
    this.change(changes, ['first', 'second', 'extent', 'window', ...(changes.time === time ? [] : (['time'] as const))]);
  };

  moveTo = (time: number): void => this.choose({ time: clamped(time, this.state.extent) });

  methodNamed = (name: string | null): Method | undefined => this.methods.find((method) => method.name === name);

  /** Of the theme; grey where a method has failed and is shown as it was before. */
  colours = (state: Readonly<State>): Colours => {
    const colours = coloursOf(state);
    const own = (which: 'first' | 'second') => (this.methodNamed(state[which])?.failure ? colours.reference : colours[which]);
    return { ...colours, first: own('first'), second: own('second') };
  };

  /** The keys that the curve of a method goes through. */
  keysOf = (method: Method | undefined) => method?.keys ?? this.report.keys;

  /** For as long as there is the viewer. */
  listen(target: EventTarget, type: string, listener: (event: never) => void): void {
    target.addEventListener(type, listener as EventListener);
    this.atEnd(() => target.removeEventListener(type, listener as EventListener));
  }

  /** Tells of each change of an element's size, for as long as there is the viewer. */
  watchSize(element: Element, update: () => void): void {
    const observer = new ResizeObserver(update);
    observer.observe(element);
    this.atEnd(() => observer.disconnect());
  }

  /** Is called when the viewer is destroyed. */
  atEnd(ending: () => void): void {
    this.endings.push(ending);
  }

  destroy(): void {
    this.choose({ playing: false });
    this.subscribers.clear();
    for (const ending of this.endings.splice(0)) ending();
  }
}
