// SPDX-License-Identifier: Apache-2.0
// What is odd about the curve, a line for each, with a method that cures it, which the library is asked for.
import { element } from 'orispline-viewer/look/element';
import { chosen as written } from 'orispline-viewer/look/number';
import type { Choice, StudioDocument } from '../document/document';
import { methodText } from '../document/methodText';
import { remedied } from '../edits/remedy';
import type { Remedy } from '../engine/protocol';
import { findingsIn, type Findings } from '../store/findings';
import { meaningOf } from '../store/meanings';
import { ownParameters } from '../store/parameters';
import { reachedText } from '../store/reached';
import type { Studio } from '../store/studio';

const quiet = 250; // [ms] without an edit: the library is not asked during a drag
const same = 1e-6; // [rad]
const degree = Math.PI / 180;

const keysText = (keys: readonly number[]): string => {
  const numbers = keys.map((index) => String(index + 1));
  if (numbers.length > 4) return `${numbers.length} keys`;
  return numbers.length === 1 ? `key ${numbers[0]}` : `keys ${numbers.slice(0, -1).join(', ')} and ${numbers[numbers.length - 1]}`;
};
const spansText = (spans: readonly number[]): string => (spans.length > 3 ? `in ${spans.length} places` : spans.map((span) => `between keys ${span + 1} and ${span + 2}`).join(' and '));
const angle = (size: number): string => `${size < 10 ? size.toPrecision(2) : Math.round(size)}°`;

class Line {
  readonly element = element('p', { className: 'advice', hidden: true, attributes: { role: 'status' } });
  private readonly text = element('span');
  private readonly offered = element('span', { className: 'offered' });
  private asked: StudioDocument | null = null; // for whose keys a method is asked for

  constructor(
    private readonly studio: Studio,
    private readonly sentenceOf: (findings: Findings, choice: Choice) => string | null,
    private readonly ask: (document: StudioDocument, findings: Findings) => Promise<Remedy | null>,
    private readonly said: (remedy: Remedy) => string,
    private readonly took: (remedy: Remedy) => void,
  ) {}

  show(document: StudioDocument, findings: Findings | null): void {
    const sentence = findings && this.sentenceOf(findings, document.first);
    this.element.hidden = !sentence;
    if (!findings || !sentence) {
      this.element.replaceChildren();
      this.asked = null;
      return;
    }
    this.text.textContent = sentence;
    if (document === this.asked) return;
    this.asked = document;
    this.offered.replaceChildren(); // that of the keys before
    this.element.replaceChildren(this.text, this.offered);
    setTimeout(() => void this.offer(document, findings), quiet);
  }

  private async offer(document: StudioDocument, findings: Findings): Promise<void> {
    if (this.asked !== document) return;
    const remedy = await this.ask(document, findings).catch(() => null);
    if (this.asked !== document) return;
    if (!remedy) return;
    const take = () => {
      const { store } = this.studio;
      if (store.current().document !== document) return; // another one is offered at once
      store.edit(remedied(document, remedy));
      this.took(remedy);
    };
    const button = element('button', { type: 'button', className: 'side', onclick: take, title: methodText(remedy.choice) }, `Use ${remedy.choice.method}`);
    this.offered.replaceChildren(button, element('small', {}, this.said(remedy)));
  }
}

/** Below the head. */
export function adviceOf(studio: Studio, tell: (sentence: string) => void): HTMLElement[] {
  const { store, engine, methods } = studio;
  const spin = new Line(
    studio,
    ({ turn, need, spun }, { method }) =>
      spun.length > 0 ? `${method} turns ${written(Number((turn / need).toPrecision(2)))} times as far as the keys need, ${angle(turn)} instead of ${angle(need)}: it spins ${spansText(spun)}.` : null,
    ({ keys, first: choice }, { need }) => engine.ask('calmest', { keys, choice, need: need * degree }),
    ({ turn, order }) => `which turns ${angle(turn / degree)}; ${reachedText(order).replace(/^smooth.*/, 'it is smooth')} at keys`,
    () => {},
  );
  const jump = new Line(
    studio,
    ({ jumps }, { method }) => (jumps.length > 0 ? `${method} is smooth on even times only: it jumps at ${keysText(jumps)}.` : null),
    ({ keys, first: choice }) => engine.ask('ofAnyTimes', { keys, choice }),
    ({ apart }) => (apart !== null && apart < same ? 'which is smooth on any times, and the same curve on even ones' : `which is smooth on any times, and within ${angle((apart ?? 0) / degree)} of it on even ones`),
    ({ choice }) => {
      const { document } = store.current();
      const [parameter] = ownParameters(document, methods);
      if (parameter) tell(`${choice.method} goes on with each ${parameter.info.name} as it was. ${meaningOf(choice.method, parameter.info)}`);
    },
  );
  const show = () => {
    const state = store.current();
    if (state.curvesOf !== state.document) return; // its curve comes
    const findings = findingsIn(state, methods);
    spin.show(state.document, findings);
    jump.show(state.document, findings);
  };
  store.subscribe(['curves', 'document'], show);
  return [spin.element, jump.element];
}
