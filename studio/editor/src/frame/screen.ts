// SPDX-License-Identifier: Apache-2.0
// The one screen of the studio: scenes, timeline, plots and the chosen key in their places.
import { playbackOf } from 'orispline-viewer/controls/playback';
import { element } from 'orispline-viewer/look/element';
import { coloursOf, paint } from 'orispline-viewer/look/theme';
import { componentsChoice, plotControls, showPlots, type PlottedOf } from 'orispline-viewer/plots/plots';
import { methodQuantities } from 'orispline-viewer/quantities/methods';
import { letters } from '../document/document';
import { AllKeys } from '../panels/allKeys';
import { KeyPanel } from '../panels/keyPanel';
import { KeyTable } from '../panels/keyTable';
import { Orientations } from '../panels/orientation';
import { scenesOf } from '../scene/scenes';
import type { Studio } from '../store/studio';
import { Actions } from '../timeline/actions';
import { Timeline } from '../timeline/timeline';
import { headOf, type Wishes } from './head';
import { hearShortcuts, shortcutsOf, showHelp } from './keyboard';
import { Notices } from './notices';

const plotted = ['w', 'a', 'j', 'apart']; // quantities, in this order
const titles: Record<string, string> = { apart: `Angle from ${letters.first} to ${letters.second}` }; // where the page has words of its own

const group = (className: string, label: string, ...children: HTMLElement[]) => element('div', { className, attributes: { role: 'group', 'aria-label': label } }, ...children);

export class Screen {
  readonly element = element('div', { className: 'orispline-viewer orispline-studio', tabIndex: -1 });
  readonly notices = new Notices();
  readonly plotted: PlottedOf;
  private readonly table: KeyTable;

  constructor(studio: Studio, wishes: Omit<Wishes, 'help'>) {
    const { view } = studio;
    const { element: root, notices } = this;
    view.subscribe(['theme'], (state) => {
      root.dataset.theme = state.theme;
      paint(root, coloursOf(state));
    });
    const actions = new Actions(studio, (sentence) => notices.tell(sentence));
    const orientations = new Orientations();
    this.table = new KeyTable(studio, orientations);
    const allKeys = new AllKeys(studio);
    const timeline = new Timeline(studio, actions, (parameter) => allKeys.choose(parameter), allKeys.element, this.tableButton());
    const help = () => showHelp(root, shortcuts);
    const shortcuts = shortcutsOf(studio, actions, { ...wishes, help, focus: timeline.focus });
    const { body, sphere } = scenesOf(studio);
    const plots = group('plots', 'Plots');
    const playback = group('playback', 'Playback', ...playbackOf(view, [], root.ownerDocument));
    const scenes = element('div', { className: 'stages' }, body, sphere);
    const work = element('div', { className: 'work' }, element('div', { className: 'upper' }, element('div', { className: 'seen' }, scenes, timeline.element), this.table.element), plots);
    root.append(headOf(studio, { ...wishes, help }), work, element('div', { className: 'foot' }, playback, new KeyPanel(studio, orientations).element), notices.element);
    plots.append(plotControls(view, componentsChoice(view, letters.first)));
    const quantities = methodQuantities(view).filter(({ id }) => plotted.includes(id)).map((one) => ({ ...one, title: titles[one.id] ?? one.title }));
    this.plotted = showPlots(view, plots, quantities, ['first', 'second', 'components']);
    hearShortcuts(studio, root.ownerDocument, shortcuts);
    view.atEnd(() => root.remove());
  }

  private tableButton(): HTMLElement {
    const { table } = this;
    table.hidden = true;
    const button = element('button', { type: 'button', className: 'side', title: 'All keys as numbers', attributes: { 'aria-expanded': 'false' } }, 'Table');
    button.onclick = () => {
      const isOpen = button.getAttribute('aria-expanded') !== 'true';
      button.setAttribute('aria-expanded', String(isOpen));
      table.hidden = !isOpen;
    };
    return button;
  }
}
