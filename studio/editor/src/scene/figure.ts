// SPDX-License-Identifier: Apache-2.0
// A figure with a scene in it that has the focus like any other control.
import { element } from 'orispline-viewer/look/element';
import type { Painter } from 'orispline-viewer/scene/painter';
import { Stage } from 'orispline-viewer/scene/stage';
import type { Studio } from '../store/studio';
import { hearLooks, hearTurns } from './keyboard';
import { keyWords } from './words';

export type Name = 'Body' | 'Sphere';

const howTo = 'Arrow keys, Page Up and Page Down turn the chosen key by 1°, with Shift by 10°, with Ctrl by 0.1°. Alt with arrow keys turns the view.';

const figureOf = (name: Name, caption: HTMLElement[], ...children: HTMLElement[]) =>
  element('div', { className: `scene ${name.toLowerCase()}`, attributes: { role: 'group', 'aria-label': name } }, element('div', { className: 'caption' }, element('strong', {}, name), ...caption), ...children);

/** What stands in place of a scene where the browser cannot draw in space. */
export const withoutGraphics = (name: Name): HTMLElement =>
  figureOf(name, [], element('p', { className: 'facts' }, 'This scene is not shown: this browser has no WebGL. All else works, and keys are turned by their numbers.'));

export interface Figure {
  figure: HTMLElement;
  frame: HTMLElement;
  stage: Stage;
  tip: (text: string | null) => void; // says what is under the pointer, or is pulled
}

/** `caption`: what stands beside its name. */
export function figureWith(studio: Studio, painter: Painter, name: Name, caption: HTMLElement[]): Figure {
  const { store, view } = studio;
  const frame = element('div', { className: 'frame' });
  const figure = figureOf(name, caption, frame);
  const stage = new Stage(view, painter, frame);
  const hint = element('p', { className: 'hint', id: `orispline-turning-${name.toLowerCase()}` }, howTo);
  const said = element('p', { className: 'unseen', attributes: { role: 'status' } });
  const tip = element('p', { className: 'hint now', hidden: true, attributes: { 'aria-hidden': 'true' } });
  frame.append(hint, said, tip);
  stage.canvas.tabIndex = 0;
  stage.canvas.setAttribute('role', 'application');
  stage.canvas.setAttribute('aria-describedby', hint.id);
  stage.canvas.addEventListener('pointerdown', ({ pointerType }) => pointerType !== 'mouse' && stage.canvas.focus({ preventScroll: true })); // as a mouse does
  const describe = () => stage.describe(keyWords(store.current(), view.moments) ?? `${name}: no key is chosen`);
  view.atEnd(store.subscribe(['document', 'chosen'], describe));
  hearLooks(stage);
  hearTurns(studio, stage, () => (said.textContent = keyWords(store.current(), view.moments)));
  const tell = (text: string | null) => {
    tip.hidden = text === null;
    tip.textContent = text ?? '';
  };
  return { figure, frame, stage, tip: tell };
}
