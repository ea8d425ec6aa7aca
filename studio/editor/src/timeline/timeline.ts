// SPDX-License-Identifier: Apache-2.0
// The keys over time, with a parameter of each: the group `Time`.
import { element, menu } from 'orispline-viewer/look/element';
import { ownParameters, type OwnParameter } from '../store/parameters';
import { marks } from '../store/reached';
import type { Studio } from '../store/studio';
import type { Actions } from './actions';
import { Bars } from './bars';
import { Dots } from './dots';
import { roundTime, timeAt } from './scale';
import { Track } from './track';

const zoomStep = 1.5;

export class Timeline {
  readonly element = element('div', { className: 'timeline', attributes: { role: 'group', 'aria-label': 'Time' } });
  private readonly track: Track;
  private readonly dots: Dots;
  private readonly bars: Bars;
  private readonly none = element('p', { className: 'facts none' });
  private readonly parameterMenu: HTMLElement;
  private readonly parameterSelect: HTMLSelectElement;
  private parameters: OwnParameter[] = [];
  private name = ''; // of the parameter that bars show, while methods have it

  /** `tell`: which parameter the bars show. `tools`: what else stands in the head. */
  constructor(
    private readonly studio: Studio,
    private readonly actions: Actions,
    private readonly tell: (parameter: OwnParameter | null) => void,
    ...tools: HTMLElement[]
  ) {
    this.track = new Track(studio);
    this.dots = new Dots(studio, this.track, actions);
    this.bars = new Bars(studio, this.track, this.dots);
    [this.parameterMenu, this.parameterSelect] = menu('Bars', [], (name) => this.chooseParameter(name));
    this.track.element.append(this.dots.element, this.bars.element, this.none);
    this.track.element.addEventListener('dblclick', (event) => {
      const x = this.track.placeIn(event);
      if (!this.dots.isAt(x)) void actions.insert(roundTime(this.track.scale, timeAt(this.track.scale, x)));
    });
    this.element.append(this.head(tools), this.track.element);
    studio.store.subscribe(['document'], () => this.showParameters());
  }

  /** The chosen key on the timeline. */
  focus = (): void => this.dots.focus();

  private head(tools: HTMLElement[]): HTMLElement {
    const { view, store } = this.studio;
    const button = (word: string, title: string, onclick: () => void) => element('button', { type: 'button', className: 'side', title, onclick, attributes: { 'aria-label': `${word} key` } }, word);
    const sign = (text: string, label: string, onclick: () => void) => element('button', { type: 'button', className: 'side sign', title: label, onclick, attributes: { 'aria-label': label } }, text);
    const insert = button('Insert', 'Insert a key on the curve at this time (I)', () => void this.actions.insert(view.current().time));
    const duplicate = button('Duplicate', 'Duplicate the chosen key (Ctrl+D)', () => this.actions.duplicate());
    const remove = button('Delete', 'Delete the chosen key (Delete)', () => this.actions.remove());
    const whole = sign('↔', 'Show all of the time', () => view.choose({ window: view.current().extent }));
    duplicate.classList.add('rare');
    this.parameterMenu.classList.add('rare');
    store.subscribe(['chosen', 'document'], ({ chosen, document }) => {
      duplicate.disabled = chosen === null;
      remove.disabled = chosen === null || document.keys.length < 3;
    });
    view.subscribe(['window', 'extent'], ({ window, extent }) => (whole.disabled = window[0] <= extent[0] && window[1] >= extent[1]));
    const zoom = element('span', { className: 'buttons rare' }, sign('−', 'Zoom out', () => this.track.zoom(zoomStep)), sign('+', 'Zoom in', () => this.track.zoom(1 / zoomStep)), whole);
    const legend = element('span', { className: 'legend', title: Object.entries(marks).flat().join(' ') }, '◆ smooth ◇ jump');
    return element('div', { className: 'title' }, element('h2', {}, 'Time'), legend, element('span', { className: 'buttons' }, insert, duplicate, remove), this.parameterMenu, ...tools, zoom);
  }

  private showParameters(): void {
    const { document } = this.studio.store.current();
    const parameters = ownParameters(document, this.studio.methods);
    const nameOf = ({ which, info }: OwnParameter) => `${document[which].method} ${info.name}`;
    if (parameters.map(nameOf).join() === this.parameters.map(nameOf).join() && parameters.length > 0 && this.parameters.every(({ info }, i) => info === parameters[i].info)) return;
    this.parameters = parameters;
    this.parameterSelect.replaceChildren(...parameters.map(({ info }) => new Option(info.name)));
    this.parameterMenu.hidden = parameters.length < 2;
    this.none.textContent = parameters.length === 0 ? `Neither ${document.first.method} nor ${document.second.method} has a value for each key. Tension has one, of timed-c2 for example.` : '';
    this.chooseParameter(this.name);
  }

  private chooseParameter(name: string): void {
    const parameter = this.parameters.find(({ info }) => info.name === name) ?? this.parameters[0] ?? null;
    if (parameter) this.parameterSelect.value = parameter.info.name;
    if (parameter && this.parameters.some(({ info }) => info.name === name)) this.name = name;
    this.bars.choose(parameter);
    this.tell(parameter);
  }
}
