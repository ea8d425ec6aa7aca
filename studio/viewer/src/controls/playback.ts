// SPDX-License-Identifier: Apache-2.0
// The bar at the foot: what is shown, and the time.
import { element, menu } from '../look/element';
import type { Store } from '../store/store';

const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** Moves the time on with the clock while it plays; begins again at the end. */
function run({ current, moveTo, subscribe }: Store): void {
  let before = 0;
  const step = (now: number) => {
    const { playing, speed, time, extent } = current();
    if (!playing) return;
    const next = time + (speed * (now - before)) / 1000;
    before = now;
    moveTo(next > extent[1] ? extent[0] : next);
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

/** The space bar plays and pauses, where it does nothing else. */
function hearKeys(store: Store, target: EventTarget): void {
  store.listen(target, 'keydown', (event: KeyboardEvent) => {
    if (event.key !== ' ' || (event.target as Element).closest('button, select, input')) return;
    event.preventDefault();
    store.choose({ playing: !store.current().playing });
  });
}

/** `keys`: where keys are heard. */
export function playbackOf(store: Store, menus: HTMLElement[], keys: EventTarget): HTMLElement[] {
  hearKeys(store, keys);
  run(store);
  return [element('div', { className: 'methods' }, ...menus), element('div', { className: 'time' }, ...timeControls(store))];
}
