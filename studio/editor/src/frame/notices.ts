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

  /** Takes the last refusal away, for something else is tried. */
  forget(): void {
    for (const old of this.element.querySelectorAll('.refused')) old.remove();
  }

  /** Those of another place are told here from now on. */
  take(others: Notices): void {
    this.element.append(...others.element.children);
  }

  /** Trouble, and what can be answered, stays until it is closed. A refusal takes the place of the one before. */
  tell(sentence: string, { actions = [], isTrouble = false, isRefusal = false }: { actions?: Action[]; isTrouble?: boolean; isRefusal?: boolean } = {}): void {
    if (isRefusal) this.forget();
    for (const old of [...this.element.children]) if (old.firstChild?.textContent === sentence) old.remove();
    const end = () => line.remove();
    const buttons = actions.map(({ label, chosen }) => {
      const answer = () => {
        if (!isRefusal) end(); // it stays until the file is opened
        chosen();
      };
      return element('button', { type: 'button', className: 'side', onclick: answer }, label);
    });
    const close = element('button', { type: 'button', className: 'close', onclick: end, attributes: { 'aria-label': 'Close this notice' } }, '✕');
    const line = element('div', { className: `notice${isTrouble || isRefusal ? ' trouble' : ''}${isRefusal ? ' refused' : ''}` }, element('span', {}, sentence), ...buttons, close);
    this.element.append(line);
    if (!isTrouble && !isRefusal && actions.length === 0) setTimeout(end, stay);
  }
}
