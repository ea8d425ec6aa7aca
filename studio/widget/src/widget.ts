// SPDX-License-Identifier: Apache-2.0
// The widget of notebooks, as anywidget wants it: a viewer of the curve, and the table of its keys below.
import './widget.css';
import { createViewer, readDocument, type State, type Viewer } from 'orispline-viewer';
import { KeyTable } from './keyTable';
import { keyRows, send, type Edit, type Model, type Shared } from './model';
import { hostTheme, watchHostTheme } from './hostTheme';

const pause = 100; // [ms] between times that Python is told while the motion plays

const kept = ['time', 'playing', 'speed', 'axis', 'body', 'place', 'components', 'theme'] as const;

/** What the user has chosen, in another curve. */
function chosenIn({ current }: Viewer, { extent }: Readonly<State>): Partial<State> {
  const state = current();
  const within = (time: number) => Math.min(Math.max(time, extent[0]), extent[1]);
  const choices = Object.fromEntries(kept.map((name) => [name, state[name]])) as Partial<State>;
  const isWhole = state.window[0] === state.extent[0] && state.window[1] === state.extent[1];
  return { ...choices, time: within(state.time), ...(isWhole ? {} : { window: state.window.map(within) as State['window'] }) };
}

class Widget {
  private readonly place = document.createElement('div');
  private readonly table: KeyTable;
  private viewer?: Viewer;
  private told = 0; // [ms] when Python was told a time
  private later?: ReturnType<typeof setTimeout>;
  private last?: Edit;
  private readonly endings: (() => void)[] = [];

  constructor(
    private readonly model: Model,
    element: HTMLElement,
  ) {
    const editor = { send: this.send, time: () => this.viewer?.current().time ?? 0, goTo: (time: number) => this.viewer?.choose({ time }) };
    this.table = new KeyTable(editor);
    this.place.className = 'shown';
    this.place.style.height = `${model.get('height')}px`;
    element.classList.add('orispline-widget');
    element.dataset.lmSuppressShortcuts = 'true'; // JupyterLab's own keys, such as D for the cell, are not for what is typed here
    element.append(this.place, this.table.element);
    this.showCurve();
    this.table.show(keyRows(model));
    this.listen('document', this.showCurve);
    this.listen('rows', () => this.table.show(keyRows(model)));
    this.listen('answered', this.hearAnswer);
    this.listen('seconds', () => this.moveTo(model.get('seconds')));
    this.endings.push(watchHostTheme((theme) => this.paint(theme)));
  }

  destroy(): void {
    for (const end of this.endings) end();
    clearTimeout(this.later);
    this.viewer?.destroy();
  }

  private listen(name: keyof Shared, listener: () => void): void {
    this.model.on(`change:${name}`, listener);
    this.endings.push(() => this.model.off(`change:${name}`, listener));
  }

  private readonly send = (edit: Edit) => {
    this.last = edit;
    send(this.model, edit);
  };

  private readonly showCurve = () => {
    const report = readDocument(JSON.parse(new TextDecoder().decode(this.model.get('document'))));
    const before = this.viewer;
    this.viewer = createViewer(this.place, report);
    if (before) this.viewer.choose(chosenIn(before, this.viewer.current()));
    else this.moveTo(this.model.get('seconds'));
    before?.destroy();
    this.paint(hostTheme());
    this.viewer.subscribe(['time'], () => {
      this.table.showTime();
      this.tell();
    });
  };

  private paint(theme: State['theme'] | undefined): void {
    if (theme) this.viewer?.choose({ theme });
    const root = this.place.parentElement;
    if (root && this.viewer) root.dataset.theme = this.viewer.current().theme;
  }

  private readonly hearAnswer = () => {
    if (this.model.get('answered') !== this.model.get('edit').number) return; // another one is on its way
    const refusal = this.model.get('refusal');
    if (refusal) this.table.refuse(refusal, this.last?.kind === 'set' ? this.last.key : undefined);
    else this.table.show(keyRows(this.model));
  };

  private moveTo(time: number): void {
    const [from, to] = this.viewer!.current().extent;
    this.viewer!.choose({ time: Math.min(Math.max(time, from), to) });
  }

  /** Now, or after the pause. */
  private tell(): void {
    clearTimeout(this.later);
    const wait = this.told + pause - performance.now();
    if (wait > 0) this.later = setTimeout(() => this.tell(), wait);
    else if (this.viewer && this.viewer.current().time !== this.model.get('seconds')) {
      this.told = performance.now();
      this.model.set('seconds', this.viewer.current().time);
      this.model.save_changes();
    }
  }
}

export default {
  render({ model, el }: { model: Model; el: HTMLElement }) {
    const widget = new Widget(model, el);
    return () => widget.destroy();
  },
};
