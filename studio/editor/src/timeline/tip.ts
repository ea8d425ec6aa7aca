// SPDX-License-Identifier: Apache-2.0
// A sentence below what it explains, or above it where there is no room, for as long as that is pointed at, pulled or has the focus.
import { element } from 'orispline-viewer/look/element';

const margin = 6; // [px]

export class Tip {
  readonly element = element('p', { className: 'tip', hidden: true, attributes: { 'aria-hidden': 'true' } }); // readers of screens are told by descriptions

  show(text: string, beside: HTMLElement): void {
    this.element.textContent = text;
    this.element.hidden = false;
    const { left, top, bottom, width } = beside.getBoundingClientRect();
    const own = this.element.getBoundingClientRect();
    this.element.style.left = `${Math.min(Math.max(left + width / 2 - own.width / 2, margin), innerWidth - margin - own.width)}px`;
    this.element.style.top = `${bottom + own.height + margin < innerHeight ? bottom + margin : Math.max(top - own.height - margin, margin)}px`;
  }

  hide(): void {
    this.element.hidden = true;
  }
}
