// SPDX-License-Identifier: Apache-2.0
// What is seen until something is open, or where nothing can be opened.
import { element } from 'orispline-viewer/look/element';
import { coloursOf, paint } from 'orispline-viewer/look/theme';

/** Of the page; a file that is open has its own name. */
export const product = 'orispline studio';

export class Start {
  readonly element = element('div', { className: 'orispline-viewer orispline-studio start', tabIndex: -1 });

  constructor() {
    const what = 'Orientations at times, and smooth curves through them: turn a key, move it in time, and see velocity, acceleration and path follow. Nothing leaves this page.';
    this.element.append(element('div', { className: 'begin' }, element('h1', {}, product), element('p', { className: 'facts' }, what)));
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const show = () => {
      const theme = dark.matches ? 'dark' : 'light';
      this.element.dataset.theme = theme;
      paint(this.element, coloursOf({ theme }));
    };
    dark.addEventListener('change', show);
    show();
  }
}
