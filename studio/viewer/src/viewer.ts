// SPDX-License-Identifier: Apache-2.0
// A viewer in an element of any page. It has nothing outside of that element, so that there may be several.
import './style/ground.css';
import './style/tables.css';
import './style/motion.css';
import './style/playback.css';
import './style/narrow.css';
import './style/print.css';
import { headerOf } from './controls/header';
import type { Report } from './data/report';
import { showMethods } from './layout/methods';
import { placesIn } from './layout/places';
import { printLight } from './layout/printing';
import { showSkeleton } from './layout/skeleton';
import type { PlottedOf } from './plots/plots';
import { element } from './look/element';
import { coloursOf, paint } from './look/theme';
import { Store } from './store/store';

export { readDocument, type ReportDocument } from './data/document';
export { reportOf, type Report } from './data/report';
export type { State } from './store/store';

export interface Viewer extends Pick<Store, 'choose' | 'current' | 'subscribe'> {
  /** The lines of a plot, such as `angle`, `apart`, `w`: of each its label, times [s] and values; NaN breaks a line. */
  plotted: PlottedOf;
  /** Leaves the element as it was. */
  destroy: () => void;
}

export interface Options {
  /** Where keys are heard, such as the whole document; else the viewer hears those that are pressed in it. */
  keys?: EventTarget;
}

export function createViewer(place: HTMLElement, report: Report, { keys }: Options = {}): Viewer {
  const store = new Store(report);
  const root = element('div', { className: 'orispline-viewer', tabIndex: -1 });
  store.subscribe(['theme'], (state) => {
    root.dataset.theme = state.theme;
    paint(root, coloursOf(state));
  });
  place.append(root);
  store.atEnd(() => root.remove());
  printLight(store);
  root.append(headerOf(store));
  const places = placesIn(root, keys ?? root);
  const plotted = report.skeleton ? showSkeleton(store, report.skeleton, places) : showMethods(store, places);
  const { choose, current, subscribe } = store;
  return { choose, current, subscribe, plotted, destroy: () => store.destroy() };
}
