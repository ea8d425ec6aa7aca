// SPDX-License-Identifier: Apache-2.0
// How curves look: look.json, which what matplotlib draws of them in Python has too.
import look from './look.json';

/** Colours, told apart by every eye, on light and on dark ground. */
export type Colours = typeof look.light;

/** Of lines [px]. */
export const { widths } = look;

export const coloursOf = ({ theme }: { theme: 'light' | 'dark' }): Colours => look[theme];

/** Of a quantity by its word: the title of its plot, and its unit. */
export function wordsOf(quantity: keyof typeof look.quantities): { title: string; unit: string } {
  const { title, unit } = look.quantities[quantity];
  return { title: title[0].toUpperCase() + title.slice(1), unit };
}

/** The colours that the styles have by the same names. */
export function paint(element: HTMLElement, { first, second, ink, faint, ground }: Colours): void {
  for (const [name, colour] of Object.entries({ first, second, ink, faint, card: ground })) element.style.setProperty(`--${name}`, colour);
}
