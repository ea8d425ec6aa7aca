// SPDX-License-Identifier: Apache-2.0
// What stands above the motion with which the page opens: what is seen, and in one line what one may begin with.
import { element } from 'orispline-viewer/look/element';
import { templates, type Template } from '../document/templates';
import { ask } from './dialog';
import type { Given } from './opening';

export interface Beginning {
  open: () => void;
  given: (given: Given) => void;
}

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

export const givenOf = ({ text, name, first, second, looks }: Template): Given => ({ bytes: bytesOf(text), name, method: first, beside: second, looks });

async function typed(place: HTMLElement, given: (given: Given) => void): Promise<void> {
  const text = element('textarea', { rows: 8, spellcheck: false, placeholder: 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.7071,0,0,0.7071', attributes: { 'aria-label': 'Keys as CSV' } });
  const how = element('p', {}, 'A row for each key: its time, and its orientation as a quaternion. A text may also be pasted anywhere on the page.');
  if ((await ask(place, 'Keys as text', [how, text], [{ label: 'Use this text', isFirst: true }, { label: 'Cancel' }])) === 'Use this text') given({ bytes: bytesOf(text.value), name: 'pasted.csv' });
}

export function welcomeOf({ open, given }: Beginning, tour: () => void): HTMLElement {
  const button = (label: string, onclick: () => void, title = '', className = 'side') => element('button', { type: 'button', className, title, onclick }, label);
  const coloured = (which: string, word: string) => element('strong', { className: which }, word);
  const box: HTMLElement = element(
    'section',
    { className: 'welcome', attributes: { 'aria-label': 'Begin' } },
    element('p', { className: 'motto' }, coloured('second', 'Orange'), ' jerks at each key, ', coloured('first', 'blue'), ' does not: drag a key.'),
    element(
      'p',
      { className: 'line' },
      button('Open a file…', open, 'Or drop a file anywhere on this page', 'play'),
      element('span', { className: 'facts' }, 'or drop one,'),
      button('Paste…', () => void typed(box, given), 'Keys as text'),
      element('span', { className: 'facts' }, 'or begin with'),
      ...templates.map((template) => button(template.title, () => given(givenOf(template)), template.sentence)),
      button('Tour', tour, 'Five steps through the page'),
    ),
  );
  return box;
}
