// SPDX-License-Identifier: Apache-2.0
// How a file is read where it does not say so itself.

export interface Reading {
  readonly options: Readonly<Record<string, string | boolean>>; // of the library, such as `fps`
  readonly comma: boolean; // numbers have decimal commas
}

export const plainReading: Reading = { options: {}, comma: false };

const number = /(?<=^|[;\t "])[-+]?\d*,\d+(?:[eE][-+]?\d+)?(?=$|[;\t "\r])/gm;

/** A text, or one line of it, with points in the place of the decimal commas of its cells; all else stays where it is. */
export const pointed = (text: string): string => text.replace(number, (cell) => cell.replace(',', '.'));

/** A text as the library is given it. */
export const textFor = (text: string, { comma }: Reading): string => (comma ? pointed(text) : text);

/** Whether cells of a text are numbers with decimal commas, so that another sign parts the cells. */
export const hasCommas = (text: string): boolean => text.split('\n').some((line) => !/^[ \t]*#/.test(line) && /[;\t]/.test(line) && pointed(line) !== line);
