// SPDX-License-Identifier: Apache-2.0
// What is seen where there are no keys yet: a file to open, a text to paste, a template to begin with.
import { element } from 'orispline-viewer/look/element';
import { coloursOf, paint } from 'orispline-viewer/look/theme';
import { templates } from '../document/templates';
import { picked, type Given } from './opening';

export class Start {
  readonly element = element('div', { className: 'orispline-viewer orispline-studio start', tabIndex: -1 });
  private readonly trouble = element('p', { className: 'trouble', attributes: { role: 'alert' } });

  constructor(private readonly given: (given: Given) => void) {
    const open = element('button', { type: 'button', className: 'play', onclick: () => void this.pick() }, 'Open a file…');
    const text = element('textarea', { rows: 4, spellcheck: false, placeholder: 't,qw,qx,qy,qz\n0,1,0,0,0\n1,0.7071,0,0,0.7071', attributes: { 'aria-label': 'Keys as CSV' } });
    const use = element('button', { type: 'button', className: 'side', onclick: () => this.given({ bytes: new TextEncoder().encode(text.value), name: 'pasted.csv' }) }, 'Use this text');
    const cards = templates.map((template) =>
      element('button', { type: 'button', className: 'card', onclick: () => this.given({ bytes: new TextEncoder().encode(template.text), name: template.name, method: template.first, beside: template.second, looks: template.looks }) }, element('strong', {}, template.title), element('span', {}, template.sentence)),
    );
    this.element.append(
      element(
        'div',
        { className: 'begin' },
        element('h1', {}, 'Keys to drag'),
        element('p', { className: 'facts' }, 'Orientations at times, and smooth curves through them: turn a key, move it in time, pull its tension, and see velocity, acceleration and path follow. Nothing leaves this page.'),
        element('section', { attributes: { 'aria-label': 'Your keys' } }, element('h2', {}, 'Your keys'), element('p', { className: 'line' }, open, element('span', { className: 'facts' }, 'or drop it anywhere on this page')), text, element('p', { className: 'line' }, use, element('span', { className: 'facts' }, 'or paste it anywhere'))),
        this.trouble,
        element('section', { attributes: { 'aria-label': 'Templates' } }, element('h2', {}, 'Or begin with a template'), element('div', { className: 'cards' }, ...cards)),
      ),
    );
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const show = () => {
      const theme = dark.matches ? 'dark' : 'light';
      this.element.dataset.theme = theme;
      paint(this.element, coloursOf({ theme }));
    };
    dark.addEventListener('change', show);
    show();
  }

  tell(sentence: string): void {
    this.trouble.textContent = sentence;
  }

  private async pick(): Promise<void> {
    try {
      const found = await picked();
      if (found) this.given(found);
    } catch (reason) {
      this.tell((reason as Error).message);
    }
  }
}
