// SPDX-License-Identifier: Apache-2.0
// The bar at the foot: what is shown, and the time.
import { element, menu } from '../look/element';
import type { State, Store } from '../store/store';

const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** Moves the time on with the clock while it plays; at the end of what the plots show it begins again. */
function run({ current, moveTo, subscribe }: Store): void {
  let before = 0;
  const step = (now: number) => {
    const { playing, speed, time, window } = current();
    if (!playing) return;
    const next = time + (speed * (now - before)) / 1000;
    before = now;
    moveTo(next > window[1] || next < window[0] ? window[0] : next);
    requestAnimationFrame(step);
  };
  subscribe(['playing'], ({ playing }) => {
    if (!playing) return;
    before = performance.now();
    requestAnimationFrame(step);
  });
}

export function methodMenus({ methods, choose, subscribe }: Store): HTMLElement[] {
  const names: [string, string][] = methods.map(({ name }) => [name, name]);
  const [first, firstSelect] = menu('Method', names, (name) => choose({ first: name }));
  const [second, secondSelect] = menu('beside', [['', 'none'], ...names], (name) => choose({ second: name || null }));
  firstSelect.classList.add('first');
  secondSelect.classList.add('second');
  subscribe(['first', 'second'], (state) => {
    firstSelect.value = state.first ?? '';
    secondSelect.value = state.second ?? '';
  });
  return [first, second];
}

function timeControls({ choose, current, moveTo, subscribe, moments }: Store): HTMLElement[] {
  const play = element('button', { type: 'button', className: 'play', onclick: () => choose({ playing: !current().playing }) });
  const scrub = element('input', {
    type: 'range',
    step: 'any',
    oninput: () => moveTo(Number(scrub.value)),
    attributes: { 'aria-label': 'Time' },
  });
  const clock = element('output', {});
  const [speed, speedSelect] = menu('Speed', speeds.map((value) => [String(value), `${value}×`]), (value) => choose({ speed: Number(value) }));
  subscribe(['playing'], ({ playing }) => {
    play.textContent = playing ? '❚❚' : '▶';
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
  });
  subscribe(['extent'], ({ extent: [from, to], time }) => {
    scrub.min = String(from);
    scrub.max = String(to);
    scrub.value = String(time);
  });
  subscribe(['time'], ({ time }) => {
    scrub.value = String(time);
    clock.textContent = moments.text(time);
    scrub.setAttribute('aria-valuetext', moments.text(time));
  });
  subscribe(['speed'], (state) => (speedSelect.value = String(state.speed)));
  return [play, scrub, clock, speed];
}

const steps: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1 }; // hundredths of what the plots show
const far = 10;

/** Where a key leads; nothing where it has no meaning here. */
function timeAfter({ key, shiftKey }: KeyboardEvent, { time, window: [from, to] }: Readonly<State>): number | null {
  if (key === 'Home') return from;
  if (key === 'End') return to;
  return key in steps ? time + (steps[key] * (shiftKey ? far : 1) * (to - from)) / 100 : null;
}

const isPressed = 'button, summary, a'; // by the space bar
const isMoved = 'select, input:not([type=checkbox], [type=range]), textarea, [contenteditable]'; // by arrows

/** The space bar plays and pauses, arrows step, Home and End jump, where they do nothing else. */
function hearKeys(store: Store, target: EventTarget): void {
  const { choose, current, moveTo } = store;
  store.listen(target, 'keydown', (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target as Element).closest(isMoved)) return;
    const time = timeAfter(event, current());
    const plays = event.key === ' ' && !(event.target as Element).closest(`${isPressed}, input[type=checkbox]`);
    if (time === null && !plays) return;
    event.preventDefault();
    if (time !== null) moveTo(time);
    else choose({ playing: !current().playing });
  });
}

/** `keys`: where keys are heard. */
export function playbackOf(store: Store, menus: HTMLElement[], keys: EventTarget): HTMLElement[] {
  hearKeys(store, keys);
  run(store);
  return [element('div', { className: 'methods' }, ...menus), element('div', { className: 'time' }, ...timeControls(store))];
}
