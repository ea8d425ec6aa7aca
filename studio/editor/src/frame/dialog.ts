// SPDX-License-Identifier: Apache-2.0
// Questions and texts in the middle of the page, which wait for an answer.
import { element } from 'orispline-viewer/look/element';

let made = 0; // dialogs have identifiers for their titles

export interface Choice {
  label: string;
  isFirst?: boolean; // what Enter does
}

/** Shows a dialog in the place; resolves with the label of the button that was pressed, null after Escape. */
export function ask(place: HTMLElement, title: string, content: (Node | string)[], choices: Choice[]): Promise<string | null> {
  const id = `orispline-dialog-${++made}`;
  const buttons = choices.map(({ label, isFirst }) =>
    isFirst ? element('button', { type: 'submit', className: 'play' }, label) : element('button', { type: 'button', className: 'side', onclick: () => dialog.close(label) }, label),
  );
  const form = element('form', {}, element('h2', { id }, title), ...content, element('div', { className: 'answers' }, ...buttons));
  const dialog: HTMLDialogElement = element('dialog', { className: 'ask', attributes: { 'aria-labelledby': id } }, form);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    dialog.close(choices.find(({ isFirst }) => isFirst)?.label);
  });
  const before = document.activeElement;
  place.append(dialog);
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove();
      if (before instanceof HTMLElement) before.focus();
      resolve(dialog.returnValue || null);
    });
    dialog.addEventListener('keydown', (event) => event.stopPropagation()); // the page's keys sleep
    dialog.showModal();
  });
}

/** Shows how far some work is while it lasts, with a button that stops it. */
export async function whileWaiting<Result>(place: HTMLElement, title: string, work: (progress: (share: number) => void) => Promise<Result>, stop: () => void): Promise<Result> {
  const bar = element('progress', { max: 1, attributes: { 'aria-label': title } }); // without a value: it is under way
  const answered = ask(place, `${title} …`, [bar], [{ label: 'Stop', isFirst: true }]);
  const dialog = bar.closest('dialog')!;
  let isDone = false;
  void answered.then(() => !isDone && stop());
  try {
    return await work((share) => (bar.value = share));
  } finally {
    isDone = true;
    dialog.close();
  }
}

export const sentences = (...texts: string[]): HTMLElement[] => texts.map((text) => element('p', {}, text));

/** A text to be taken, for the clipboard may be refused. */
export async function showText(place: HTMLElement, title: string, text: string, tell: (sentence: string) => void): Promise<void> {
  const area = element('textarea', { value: text, readOnly: true, spellcheck: false, rows: Math.min(18, text.split('\n').length + 1), attributes: { 'aria-label': title } });
  area.addEventListener('focus', () => {
    area.select();
    requestAnimationFrame(() => (area.scrollTop = 0)); // its beginning stays in view
  });
  const answer = await ask(place, title, [area], [{ label: 'Copy', isFirst: true }, { label: 'Close' }]);
  if (answer !== 'Copy') return;
  try {
    await navigator.clipboard.writeText(text);
    tell('The text is on the clipboard.');
  } catch {
    tell('The browser does not let this page write to the clipboard; mark the text and copy it with Ctrl+C.');
    void showText(place, title, text, tell);
  }
}
