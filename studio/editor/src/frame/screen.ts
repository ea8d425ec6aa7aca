// SPDX-License-Identifier: Apache-2.0
// The one screen of the studio: scenes, timeline, plots and the chosen key in their places.
import { playbackOf } from 'orispline-viewer/controls/playback';
import { element } from 'orispline-viewer/look/element';
import { coloursOf, paint } from 'orispline-viewer/look/theme';
import { componentsChoice, plotControls, showPlots, type PlottedOf } from 'orispline-viewer/plots/plots';
import { methodQuantities } from 'orispline-viewer/quantities/methods';
import { adviceOf } from '../panels/advice';
import { AllKeys } from '../panels/allKeys';
import { KeyPanel } from '../panels/keyPanel';
import { KeyTable } from '../panels/keyTable';
import { Orientations } from '../panels/orientation';
import { scenesOf } from '../scene/scenes';
import { findingsIn } from '../store/findings';
import { jumps } from '../store/reached';
import type { Studio } from '../store/studio';
import { Actions } from '../timeline/actions';
import { Timeline } from '../timeline/timeline';
import { has, keep } from './habits';
import { headOf, type Wishes } from './head';
import { hearShortcuts, shortcutsOf, showHelp } from './keyboard';
import { Notices } from './notices';
import { product } from './start';
import { Tour } from './tour';
import { welcomeOf, type Beginning } from './welcome';

const plotted = ['w', 'a', 'j', 'apart']; // quantities, in this order
const titles: Record<string, string> = { apart: 'Angle between both curves' }; // where the page has words of its own

const group = (className: string, label: string, ...children: HTMLElement[]) => element('div', { className, attributes: { role: 'group', 'aria-label': label } }, ...children);

const flagged: Record<string, number> = { w: 0, a: 1, j: 1 }; // plots of rates, and up to which order a jump is marked there

/** Where the curve spins, and where it jumps; in the plots of rates. */
const flagsOf = ({ store, methods }: Studio, id: string) => () => {
  const found = id in flagged ? findingsIn(store.current(), methods) : null;
  const { curves } = store.current();
  if (!found || !curves || !('orders' in curves.first)) return { spans: [], times: [] };
  const { keys } = found;
  const { orders } = curves.first;
  return { spans: found.spun.map((i): [number, number] => [keys[i].t, keys[i + 1].t]), times: keys.flatMap(({ t }, i) => (jumps(orders[i]) && orders[i] <= flagged[id] ? t : [])) };
};

export class Screen {
  readonly element = element('div', { className: 'orispline-viewer orispline-studio', tabIndex: -1 });
  readonly notices = new Notices();
  readonly plotted: PlottedOf;
  private readonly table: KeyTable;

  private readonly tour: Tour;
  private readonly isOpening: boolean;

  /** `beginning`: of what the page opens with, what may come in its place. */
  constructor(studio: Studio, wishes: Omit<Wishes, 'help' | 'more' | 'title'>, beginning?: Beginning) {
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
    this.isOpening = beginning !== undefined;
    const help = () => void showHelp(root, shortcuts, () => this.tour.begin(true));
    const shortcuts = shortcutsOf(studio, actions, { ...wishes, help, focus: timeline.focus });
    const { body, sphere } = scenesOf(studio);
    const plots = group('plots', 'Plots');
    const playback = group('playback', 'Playback', ...playbackOf(view, [], root.ownerDocument));
    const scenes = element('div', { className: 'stages' }, body, sphere);
    const work = element('div', { className: 'work' }, element('div', { className: 'upper' }, element('div', { className: 'seen' }, scenes, timeline.element), this.table.element), plots);
    root.append(headOf(studio, { ...wishes, help, more: this.moreButton(), title: beginning && product }, adviceOf(studio, (sentence) => notices.tell(sentence))), ...(beginning ? [welcomeOf(beginning, () => this.tour.begin(true))] : []), work, element('div', { className: 'foot' }, playback, new KeyPanel(studio, orientations).element), notices.element);
    plots.append(plotControls(view, componentsChoice(view, 'the curve')));
    const quantities = methodQuantities(view).filter(({ id }) => plotted.includes(id)).map((one) => ({ ...one, title: titles[one.id] ?? one.title, flags: flagsOf(studio, one.id) }));
    this.plotted = showPlots(view, plots, quantities, ['first', 'second', 'components']);
    hearShortcuts(studio, root.ownerDocument, shortcuts);
    this.tour = new Tour(root);
    view.atEnd(() => root.remove());
  }

  /** When it is on the page: who sees it for the first time is shown around. */
  begin(): void {
    if (this.isOpening && has('toured') === false) this.tour.begin(false);
  }

  /** Shows what is not needed every day. */
  private moreButton(): HTMLElement {
    const { element: root } = this;
    const button = element('button', { type: 'button', className: 'side', title: 'Further controls, everywhere on the page' }, 'More');
    const show = (is: boolean) => {
      root.classList.toggle('has-less', !is);
      button.setAttribute('aria-expanded', String(is));
    };
    button.onclick = () => {
      const is = root.classList.contains('has-less');
      show(is);
      keep('more', is);
    };
    show(has('more') === true);
    return button;
  }

  private tableButton(): HTMLElement {
    const { table } = this;
    table.hidden = true;
    const button = element('button', { type: 'button', className: 'side rare', title: 'All keys as numbers', attributes: { 'aria-expanded': 'false' } }, 'Table');
    button.onclick = () => {
      const isOpen = button.getAttribute('aria-expanded') !== 'true';
      button.setAttribute('aria-expanded', String(isOpen));
      table.hidden = !isOpen;
    };
    return button;
  }
}
