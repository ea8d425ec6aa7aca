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

export function methodMenus(store: Store): HTMLElement[] {
  const { choose, subscribe } = store;
  const [first, firstSelect] = menu('Method', [], (name) => choose({ first: name }));
  const [second, secondSelect] = menu('beside', [], (name) => choose({ second: name || null }));
  firstSelect.classList.add('first');
  secondSelect.classList.add('second');
  let names: string[] = [];
  subscribe(['first', 'second'], (state) => {
    const now = store.methods.map(({ name }) => name);
    if (now.join('\n') !== names.join('\n')) {
      names = now;
      firstSelect.replaceChildren(...names.map((name) => new Option(name)));
      secondSelect.replaceChildren(new Option('none', ''), ...names.map((name) => new Option(name)));
    }
    second.hidden = names.length < 2;
    firstSelect.value = state.first ?? '';
    secondSelect.value = state.second ?? '';
  });
  return [first, second];
}

function timeControls(store: Store): HTMLElement[] {
  const { choose, current, moveTo, subscribe } = store;
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
  subscribe(['extent'], ({ extent: [from, to] }) => {
    scrub.min = String(from);
    scrub.max = String(to);
  });
  subscribe(['time', 'extent'], ({ time }) => {
    const text = store.moments.text(time);
    scrub.value = String(time);
    clock.textContent = text;
    scrub.setAttribute('aria-valuetext', text);
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
