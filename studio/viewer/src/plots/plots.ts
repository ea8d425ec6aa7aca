// SPDX-License-Identifier: Apache-2.0
// The plots over time, one below or beside the other.
import { element } from '../look/element';
import { chordTolerance } from '../motion/lines';
import type { Quantity } from '../quantities/quantity';
import type { State, Store } from '../store/store';
import { Plot } from './plot';

/** Shows all of the time again; there while the plots show less. */
function wholeButton({ choose, current, subscribe }: Store): HTMLElement {
  const button = element('button', { type: 'button', className: 'side', onclick: () => choose({ window: current().extent }) }, 'Reset zoom');
  subscribe(['window', 'extent'], ({ window, extent }) => (button.hidden = window[0] <= extent[0] && window[1] >= extent[1]));
  return button;
}

/** Whether the components of the first method are drawn too. */
export function componentsChoice({ choose, subscribe }: Store): HTMLElement {
  const box = element('input', { type: 'checkbox', onchange: () => choose({ components: box.checked }) });
  subscribe(['components'], ({ components }) => (box.checked = components));
  return element('label', { className: 'choice' }, box, element('span', {}, 'Components x, y, z of the first method'));
}

/** The controls of all plots, above them. */
export const plotControls = (store: Store, ...choices: HTMLElement[]): HTMLElement => element('div', { className: 'controls' }, ...choices, wholeButton(store));

/** They are made anew when one of the fields changes. */
export function showPlots(store: Store, place: HTMLElement, quantities: Quantity[], fields: (keyof State)[]): void {
  const plots = quantities.map((quantity) => new Plot(store, place, quantity));
  const every = (update: (plot: Plot, state: State) => void) => (state: State) => plots.forEach((plot) => update(plot, state));
  store.subscribe([...fields, 'theme'], every((plot, state) => plot.rebuild(state)));
  store.subscribe(['window'], every((plot, state) => plot.showWindow(state)));
  store.subscribe(['time'], every((plot, state) => plot.showTime(state)));
}

const wanted = 0.005; // [deg] of the samples: a drawing that is better says no more

/** With two digits. */
function upwards(size: number): number {
  const unit = 10 ** (Math.floor(Math.log10(size)) - 1);
  return Number((Math.ceil(size / unit - 1e-9) * unit).toPrecision(2));
}

/** How exact the drawing of the methods that are shown is, where the samples say it. */
export function exactness({ methodNamed, subscribe }: Store): HTMLElement {
  const line = element('p', { className: 'facts' });
  subscribe(['first', 'second'], ({ first, second }) => {
    const reached = [first, second].flatMap((name) => methodNamed(name)?.samples.exactness_deg ?? []);
    const within = Math.max(wanted, ...reached) + chordTolerance;
    line.hidden = reached.length === 0;
    line.textContent = `Curves are drawn within ${upwards(within)}°, the angle between two within ${upwards(2 * within)}°.`;
  });
  return line;
}
