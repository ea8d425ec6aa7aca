// SPDX-License-Identifier: Apache-2.0
// Keys of the keyboard that are heard everywhere. Views that give arrows a meaning of their own, such as the scenes, keep them to themselves;
// space and arrows are the playback's.
import { element } from 'orispline-viewer/look/element';
import { marks } from '../store/reached';
import type { Studio } from '../store/studio';
import type { Actions } from '../timeline/actions';
import { ask } from './dialog';

const isTypedInto = 'input:not([type=range], [type=checkbox]), textarea, [contenteditable]';

export interface Asked {
  open: () => void;
  save: () => void;
  help: () => void;
  focus: () => void; // the chosen key on the timeline
}

interface Shortcut {
  keys: string; // as they are listed
  does: string;
  is: (event: KeyboardEvent) => boolean;
  whileTyping?: boolean;
  act: () => void;
}

const command = (key: string, shift = false) => (event: KeyboardEvent) => (event.ctrlKey || event.metaKey) && !event.altKey && event.shiftKey === shift && event.key.toLowerCase() === key;
const plain = (...keys: string[]) => (event: KeyboardEvent) => !event.ctrlKey && !event.metaKey && !event.altKey && keys.includes(event.key);

export function shortcutsOf({ store, view }: Studio, actions: Actions, { open, save, help, focus }: Asked): Shortcut[] {
  const redoes = [command('z', true), command('y')];
  const step = (by: number) => {
    const onTimeline = !!document.activeElement?.closest('.dots');
    actions.step(by);
    if (onTimeline) focus();
  };
  return [
    { keys: 'Ctrl+Z', does: 'Undo', is: command('z'), act: () => store.undo() },
    { keys: 'Ctrl+Shift+Z, Ctrl+Y', does: 'Redo', is: (event) => redoes.some((is) => is(event)), act: () => store.redo() },
    { keys: 'Ctrl+S', does: 'Save the keys', is: command('s'), whileTyping: true, act: save },
    { keys: 'Ctrl+O', does: 'Open a file', is: command('o'), whileTyping: true, act: open },
    { keys: 'Ctrl+D', does: 'Duplicate the chosen key', is: command('d'), act: () => actions.duplicate() },
    { keys: '[', does: 'Choose the key before', is: plain('['), act: () => step(-1) },
    { keys: ']', does: 'Choose the next key', is: plain(']'), act: () => step(1) },
    { keys: 'I', does: 'Insert a key on the curve at this time', is: plain('i', 'I'), act: () => void actions.insert(view.current().time) },
    { keys: 'Delete, Backspace', does: 'Delete the chosen key', is: plain('Delete', 'Backspace'), act: () => actions.remove() },
    { keys: '?', does: 'Show this list', is: plain('?'), act: help },
  ];
}

/** A letter at a menu chooses what begins with it. */
function isTypedIn({ target, key, ctrlKey, metaKey }: KeyboardEvent): boolean {
  const within = (selector: string) => !!(target as Element).closest?.(selector);
  return within(isTypedInto) || (within('select') && key.length === 1 && !ctrlKey && !metaKey);
}

export function hearShortcuts({ view }: Studio, place: EventTarget, shortcuts: Shortcut[]): void {
  view.listen(place, 'keydown', (event: KeyboardEvent) => {
    if (event.defaultPrevented) return;
    const isTyping = isTypedIn(event);
    const found = shortcuts.find(({ is, whileTyping }) => is(event) && (!isTyping || whileTyping));
    if (!found) return;
    event.preventDefault();
    if (isTyping) event.target?.dispatchEvent(new Event('change', { bubbles: true })); // what is typed counts
    found.act();
  });
}

const elsewhere: [keys: string, does: string][] = [
  ['Space', 'Play, pause'],
  ['← →', 'Step the time by a hundredth of what is shown, with Shift by a tenth'],
  ['Home, End', 'Go to the first or the last moment that is shown'],
];
const places: [where: string, lines: [string, string][]][] = [
  ['On the body or the sphere', [['← → ↑ ↓', 'Turn the chosen key about the axes of the screen by 1°, with Shift by 10°, with Ctrl by 0.1°'], ['Page Up, Page Down', 'Turn it about the line of sight by the same angles'], ['Alt+← → ↑ ↓', 'Look from elsewhere']]],
  ['On a key of the timeline', [['← →', 'Move it in time, with Shift ten times as far, with Ctrl a tenth'], ['↑ ↓', 'Choose the key before, the next one'], ['Page Up, Page Down', 'Choose the key ten before, ten later'], ['Home, End', 'Choose the first or last key'], ['Tab', 'Go to its bar']]],
  ['On a bar', [['↑ ↓, ← →', 'Change the value, with Shift ten times as much, with Ctrl a tenth'], ['Page Up, Page Down', 'Change it ten times as much']]],
  ['On the slider All keys', [['← → ↑ ↓', 'Change the value of all keys'], ['Page Up, Page Down', 'Change it ten times as much'], ['Home, End', 'Go to the least and the most']]],
  ['In a field', [['↑ ↓', 'Step the number, with Shift ten times as far, with Ctrl a tenth'], ['Enter', 'Take what was typed'], ['Escape', 'Take back what was typed']]],
  ['While dragging', [['Escape', 'End the drag where it began']]],
];

/** `tour`: what is begun instead, where that is wanted. */
export async function showHelp(place: HTMLElement, shortcuts: Shortcut[], tour: () => void): Promise<void> {
  const list = (lines: readonly [string, string][]) => element('dl', {}, ...lines.flatMap(([keys, does]) => [element('dt', {}, keys), element('dd', {}, does)]));
  const everywhere = [...elsewhere, ...shortcuts.map(({ keys, does }): [string, string] => [keys, does])];
  const parts = [['Everywhere', everywhere] as const, ...places, ['Marks of keys', Object.entries(marks)] as const].map(([where, lines]) => element('section', {}, element('h3', {}, where), list(lines)));
  const answer = await ask(place, 'Keyboard', [element('div', { className: 'help', tabIndex: 0, attributes: { role: 'region', 'aria-label': 'Keys and what they do' } }, ...parts)], [{ label: 'Close', isFirst: true }, { label: 'Take the tour' }]);
  if (answer === 'Take the tour') tour();
}
