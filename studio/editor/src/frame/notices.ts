// SPDX-License-Identifier: Apache-2.0
// Sentences for the user that do not stop the work.
import { element } from 'orispline-viewer/look/element';

const stay = 8000; // [ms] of one that nobody has to answer

export interface Action {
  label: string;
  chosen: () => void;
}

export class Notices {
  readonly element = element('div', { className: 'notices', attributes: { role: 'status' } });

  /** Trouble, and what can be answered, stays until it is closed. */
  tell(sentence: string, { actions = [], isTrouble = false }: { actions?: Action[]; isTrouble?: boolean } = {}): void {
    for (const old of [...this.element.children]) if (old.firstChild?.textContent === sentence) old.remove();
    const end = () => line.remove();
    const buttons = actions.map(({ label, chosen }) => {
      const answer = () => {
        end();
        chosen();
      };
      return element('button', { type: 'button', className: 'side', onclick: answer }, label);
    });
    const close = element('button', { type: 'button', className: 'close', onclick: end, attributes: { 'aria-label': 'Close this notice' } }, '✕');
    const line = element('div', { className: isTrouble ? 'notice trouble' : 'notice' }, element('span', {}, sentence), ...buttons, close);
    this.element.append(line);
    if (!isTrouble && actions.length === 0) setTimeout(end, stay);
  }
}
