// SPDX-License-Identifier: Apache-2.0
// The plots over time, one below or beside the other.
import { element } from '../look/element';
import { chordTolerance } from '../motion/lines';
import type { Quantity } from '../quantities/quantity';
import type { State, Store } from '../store/store';
import { cell, closestKeys } from './drawings';
import { Plot, type Plotted, type Thinned } from './plot';
import { Turns } from './turns';

/** The lines of the plot of a quantity, as they are drawn; none where there is no such plot. */
export type PlottedOf = (id: string) => Plotted[];

/** Shows all of the time again; there while the plots show less. */
function wholeButton({ choose, current, subscribe }: Store): HTMLElement {
  const button = element('button', { type: 'button', className: 'side', onclick: () => choose({ window: current().extent }) }, 'Reset zoom');
  subscribe(['window', 'extent'], ({ window, extent }) => (button.hidden = window[0] <= extent[0] && window[1] >= extent[1]));
  return button;
}

/** Whether the components of the first method are drawn too. `whose`: what the page calls it. */
export function componentsChoice({ choose, subscribe }: Store, whose = 'the first method'): HTMLElement {
  const box = element('input', { type: 'checkbox', onchange: () => choose({ components: box.checked }) });
  subscribe(['components'], ({ components }) => (box.checked = components));
  return element('label', { className: 'choice' }, box, element('span', {}, `Components x, y, z of ${whose}`));
}

/** The controls of all plots, above them. */
export const plotControls = (store: Store, ...choices: HTMLElement[]): HTMLElement => element('div', { className: 'controls' }, ...choices, wholeButton(store));

const wanted = 0.005; // [deg] of the samples: a drawing that is better says no more

/** With two digits. */
function upwards(size: number): number {
  const unit = 10 ** (Math.floor(Math.log10(size)) - 1);
  return Number((Math.ceil(size / unit - 1e-9) * unit).toPrecision(2));
}

/** How exact the drawing of the methods that are shown is, where the samples say it. */
export function exactness({ current, methodNamed }: Store): string {
  const { first, second } = current();
  const reached = [first, second].flatMap((name) => methodNamed(name)?.samples.exactness_deg ?? []);
  if (reached.length === 0) return '';
  const within = Math.max(wanted, ...reached) + chordTolerance;
  const isOne = !first || !second || first === second || [first, second].some((name) => methodNamed(name)?.clock);
  return `Curves are drawn within ${upwards(within)}°${isOne ? '' : `, the angle between two within ${upwards(2 * within)}°`}.`;
}

const thinnedKeys = `Keys are marked where they are ${closestKeys} px apart; zoom in to see all.`;
const thinnedMarks = `Of points nearer to each other than ${cell} px one is drawn.`;

/** The plots of the quantities; they are made anew when one of the fields changes. What `how` says of the drawing stands below them. */
export function showPlots(store: Store, place: HTMLElement, quantities: Quantity[], fields: (keyof State)[], how: () => string = () => ''): PlottedOf {
  const turns = new Turns(store);
  const line = element('p', { className: 'facts' });
  const tell = () => {
    const isThinned = (what: keyof Thinned) => plots.some(({ figure, thinned }) => thinned[what] && !figure.hidden);
    const text = [how(), isThinned('keys') && thinnedKeys, isThinned('marks') && thinnedMarks].filter(Boolean).join(' ');
    line.hidden = text === '';
    if (line.textContent !== text) line.textContent = text;
  };
  const plots: Plot[] = quantities.map((quantity) => new Plot(store, place, quantity, turns, tell));
  place.append(line);
  const every = (update: (plot: Plot, state: State) => void) => (state: State) => plots.forEach((plot) => update(plot, state));
  store.subscribe([...fields, 'theme'], every((plot, state) => plot.rebuild(state)));
  store.subscribe([...fields], tell);
  store.subscribe(['window'], every((plot, state) => plot.showWindow(state)));
  store.subscribe(['time'], every((plot, state) => plot.showTime(state)));
  store.listen(window, 'beforeprint', () => turns.drawAll());
  return (id) => plots.find((plot) => plot.id === id)?.plotted ?? [];
}
