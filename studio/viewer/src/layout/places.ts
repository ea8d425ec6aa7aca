// SPDX-License-Identifier: Apache-2.0
// The parts of a viewer, where they are.
import { element } from '../look/element';

export interface Places {
  main: HTMLElement; // all but the playback
  measures: HTMLElement;
  scenes: HTMLElement;
  plots: HTMLElement;
  playback: HTMLElement;
  keys: EventTarget; // where keys are heard
}

/** No landmarks, of which a page is to have one of a name. */
const part = (className: string, label: string) => element('div', { className, attributes: { role: 'group', 'aria-label': label } });

export function placesIn(root: HTMLElement, keys: EventTarget): Places {
  const measures = part('measures', 'Measures');
  const scenes = part('scenes', 'Motion in space');
  const plots = part('plots', 'Motion over time');
  const main = element('div', { className: 'main' }, measures, scenes, plots);
  const playback = part('playback', 'Playback');
  root.append(element('div', { className: 'shown' }, main, playback)); // below the head, which the playback is not to cover
  return { main, measures, scenes, plots, playback, keys };
}
