// SPDX-License-Identifier: Apache-2.0
// The bar at the top: the file, what is done with it, and the methods.
import { breakable, element } from 'orispline-viewer/look/element';
import { names, type Which } from '../document/document';
import { MethodForm } from '../panels/methodForm';
import { methodMenu, refusal } from '../panels/methodMenu';
import type { Studio } from '../store/studio';
import { formButton, menuButton, type Item } from './popup';

/** What the head can ask for. */
export interface Wishes {
  open: () => void;
  save: () => void;
  copies: Item[];
  exports: Item[];
  help: () => void;
  more: HTMLElement;
  title?: string; // else the name of the file
}

const button = (label: string, title: string, onclick: () => void, className = 'side') => element('button', { type: 'button', className, title, onclick }, label);

/** Shown with *More* only. */
function rare(made: HTMLElement): HTMLElement {
  made.classList.add('rare');
  return made;
}

function nameOf({ store, original }: Studio, title = original.name): HTMLElement {
  const dot = element('span', { className: 'unsaved', title: 'Not saved', attributes: { role: 'img', 'aria-label': 'not saved' } }, '●');
  store.subscribe(['isSaved'], ({ isSaved }) => (dot.hidden = isSaved));
  return element('h1', {}, ...breakable(title), ' ', dot);
}

function method(studio: Studio, which: Which): HTMLElement {
  const name = names[which];
  const open = element('button', { type: 'button', className: 'side sign', title: `Settings of ${name}`, attributes: { 'aria-label': `Settings of ${name}` } }, '⚙');
  const form = rare(formButton(open, `Settings of ${name}`, new MethodForm(studio, which).element));
  return element('span', { className: `method ${which}` }, element('span', { className: 'letter', attributes: { 'aria-hidden': 'true' } }, name), methodMenu(studio, which), form);
}

function themeButton({ view: { choose, current, subscribe } }: Studio): HTMLElement {
  const theme = button('', 'Light or dark', () => choose({ theme: current().theme === 'dark' ? 'light' : 'dark' }), 'theme rare');
  subscribe(['theme'], (state) => (theme.textContent = state.theme === 'dark' ? '☀ Light' : '☾ Dark'));
  return theme;
}

/** `lines`: what stands below it. */
export function headOf(studio: Studio, { open, save, copies, exports, help, more, title }: Wishes, lines: HTMLElement[]): HTMLElement {
  const { store } = studio;
  const undo = button('Undo', 'Undo (Ctrl+Z)', () => store.undo());
  const redo = button('Redo', 'Redo (Ctrl+Shift+Z)', () => store.redo());
  store.subscribe(['canUndo', 'canRedo'], ({ canUndo, canRedo }) => {
    undo.disabled = !canUndo;
    redo.disabled = !canRedo;
  });
  const group = (name: string, ...children: HTMLElement[]) => element('span', { className: `buttons ${name}` }, ...children);
  return element(
    'div',
    { className: 'top' },
    nameOf(studio, title),
    element(
      'div',
      { className: 'tools' },
      group('history', undo, redo),
      group('files', button('Open', 'Open a file (Ctrl+O)', open), button('Save', 'Save the keys (Ctrl+S)', save), rare(menuButton('Copy…', 'Copy', copies)), rare(menuButton('Export…', 'Export', exports))),
      method(studio, 'first'),
      method(studio, 'second'),
      group('looks', themeButton(studio), more, element('button', { type: 'button', className: 'side sign', title: 'Keys of the keyboard (?)', onclick: help, attributes: { 'aria-label': 'Help' } }, '?')),
    ),
    refusal(studio, 'first'),
    refusal(studio, 'second'),
    ...lines,
  );
}
