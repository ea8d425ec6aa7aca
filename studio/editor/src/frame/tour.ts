// SPDX-License-Identifier: Apache-2.0
// Five steps through the page, each beside what it is about. The page can be used meanwhile.
import { element } from 'orispline-viewer/look/element';
import { keep } from './habits';

interface Step {
  about: string; // selector
  title: string;
  text: string;
}

const steps: readonly Step[] = [
  { about: '.scene.sphere', title: 'Turn a key', text: 'Each dot on the sphere is a key. Pull one: the axis of the body points where you pull it. With the focus here arrow keys turn it.' },
  { about: '.scene.body', title: 'Turn it by rings', text: 'Pull a ring around the body to turn the chosen key about one axis. Drag an empty place to look from elsewhere.' },
  { about: '.timeline', title: 'Move it in time', text: 'Each diamond is a key, too: drag it sideways, or press the left and right arrow keys. A double click inserts a key that lies on the curve.' },
  { about: '.tools', title: 'Choose the curve', text: 'The menus at the top choose the blue curve and the orange one to compare it with. Below, the plots show where their rates jump.' },
  { about: '.files', title: 'Take it with you', text: 'Save gives your keys back, with only what you changed. Undo takes all back, More shows all other controls, and ? all keys of the keyboard.' },
];

export class Tour {
  private readonly card = element('div', { className: 'tour', hidden: true, attributes: { role: 'dialog', 'aria-modal': 'false' } });
  private step = 0;
  private before: Element | null = null;

  /** `place`: the whole of the screen. */
  constructor(private readonly place: HTMLElement) {
    this.card.addEventListener('keydown', (event) => {
      event.stopPropagation(); // the page's keys sleep
      if (event.key === 'Escape') this.leave();
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (by) this.go(this.step + by, true);
    });
    place.prepend(this.card); // the first that a keyboard reaches
  }

  /** `takesFocus`: whoever asked for it goes on from there. */
  begin(takesFocus: boolean): void {
    this.before = document.activeElement;
    this.go(0, takesFocus);
  }

  private go(step: number, takesFocus: boolean): void {
    if (step < 0) return;
    if (step >= steps.length) return this.leave();
    this.step = step;
    const { about, title, text } = steps[step];
    this.mark(about, takesFocus);
    const button = (label: string, onclick: () => void, className = 'side') => element('button', { type: 'button', className, onclick }, label);
    const isLast = step === steps.length - 1;
    const next = button(isLast ? 'Done' : 'Next', () => this.go(this.step + 1, true), 'play');
    const back = button('Back', () => this.go(this.step - 1, true));
    back.disabled = step === 0;
    const place = `Step ${step + 1} of ${steps.length}`;
    this.card.setAttribute('aria-label', `Tour: ${place}`);
    this.card.replaceChildren(element('strong', {}, title), element('p', { attributes: { role: 'status' } }, text), element('div', { className: 'answers' }, element('small', {}, place), button('Leave', () => this.leave()), back, next));
    this.card.hidden = false;
    if (takesFocus) next.focus({ preventScroll: true });
  }

  /** What the step is about; null: nothing. */
  private mark(about: string | null, isInView = false): void {
    this.place.querySelector('.is-toured')?.classList.remove('is-toured');
    const found = about === null ? null : this.place.querySelector(about);
    found?.classList.add('is-toured');
    if (isInView) found?.scrollIntoView({ block: 'nearest' });
  }

  /** For good: it is not shown again unless it is asked for. */
  private leave(): void {
    this.card.hidden = true;
    this.mark(null);
    keep('toured', true);
    if (this.before instanceof HTMLElement && this.before.isConnected) this.before.focus({ preventScroll: true });
  }
}
