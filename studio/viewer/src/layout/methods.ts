// SPDX-License-Identifier: Apache-2.0
// Methods, their measures and motions.
import { methodMenus, playbackOf } from '../controls/playback';
import { element } from '../look/element';
import { componentsChoice, exactness, plotControls, showPlots, type PlottedOf } from '../plots/plots';
import { methodQuantities } from '../quantities/methods';
import { scenesOf } from '../scene/scenes';
import type { Store } from '../store/store';
import { measureTable } from '../tables/measures';
import type { Places } from './places';

const still = 'Nothing moves here: one key is where it is at all times.';

const manyMethods = 6; // a table so long stands beside the scenes, where there is room

export function showMethods(store: Store, { main, measures, scenes, plots, playback, keys }: Places): PlottedOf {
  const { report, methods } = store;
  if (report.columns.length > 0 || report.methods.length > 0) measures.append(measureTable(store));
  if (methods.length === 0) {
    if (report.methods.some(({ failure }) => !failure)) scenes.append(element('p', { className: 'facts' }, still));
    return () => [];
  }
  main.classList.toggle('beside', report.methods.length >= manyMethods);
  playback.append(...playbackOf(store, methodMenus(store), keys));
  scenes.append(...scenesOf(store));
  plots.append(plotControls(store, componentsChoice(store)));
  return showPlots(store, plots, methodQuantities(store), ['first', 'second', 'components'], () => exactness(store));
}
