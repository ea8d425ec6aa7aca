// SPDX-License-Identifier: Apache-2.0
// What a button opens below itself: a menu, or a small form. Escape and a press elsewhere close it.
import { element } from 'orispline-viewer/look/element';

const margin = 6; // [px]

function place(button: HTMLElement, box: HTMLElement): void {
  const { left, bottom, right } = button.getBoundingClientRect();
  const { width, height } = box.getBoundingClientRect();
  const fromLeft = left + width + margin <= innerWidth ? left : Math.max(margin, Math.min(right, innerWidth - margin) - width);
  box.style.left = `${fromLeft}px`;
  box.style.top = `${Math.max(margin, Math.min(bottom + margin / 2, innerHeight - margin - height))}px`;
}

function opens(button: HTMLButtonElement, box: HTMLElement, opened: () => void): void {
  box.popover = 'auto';
  button.popoverTargetElement = box;
  button.setAttribute('aria-expanded', 'false');
  box.addEventListener('toggle', (event) => {
    const isOpen = (event as ToggleEvent).newState === 'open';
    button.setAttribute('aria-expanded', String(isOpen));
    if (!isOpen) return;
    place(button, box);
    opened();
  });
}

export interface Item {
  label: string;
  note?: string;
  chosen: () => void;
}

/** A button with a menu of things to do. */
export function menuButton(label: string, name: string, items: Item[]): HTMLElement {
  const entries = items.map(({ label, note, chosen }) => {
    const choose = () => {
      box.hidePopover();
      chosen();
    };
    return element('button', { type: 'button', className: 'entry', tabIndex: -1, attributes: { role: 'menuitem' }, onclick: choose }, label, ...(note ? [element('small', {}, note)] : []));
  });
  const box: HTMLElement = element('div', { className: 'popup menu', attributes: { role: 'menu', 'aria-label': name } }, ...entries);
  const button = element('button', { type: 'button', className: 'side', attributes: { 'aria-label': name, 'aria-haspopup': 'menu' } }, label);
  opens(button, box, () => entries[0].focus());
  box.addEventListener('keydown', (event) => {
    const here = entries.indexOf(document.activeElement as HTMLButtonElement);
    const there = { ArrowDown: here + 1, ArrowUp: here - 1, Home: 0, End: -1 }[event.key];
    if (there === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    entries.at(there % entries.length)!.focus();
  });
  return element('span', { className: 'opener' }, button, box);
}

/** A button with a form. */
export function formButton(button: HTMLButtonElement, name: string, form: HTMLElement): HTMLElement {
  const box = element('div', { className: 'popup', attributes: { role: 'dialog', 'aria-label': name } }, form);
  button.setAttribute('aria-haspopup', 'dialog');
  opens(button, box, () => box.querySelector<HTMLElement>('input, select, button')?.focus());
  return element('span', { className: 'opener' }, button, box);
}
