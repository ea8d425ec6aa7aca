// SPDX-License-Identifier: Apache-2.0
// How a column of times says when its keys are, and what stands there of a key that was moved: its time, exact.
import { type Decimal, decimalOf, decimalText, difference, equal, numberOf, quotient, shifted, shortest, sum, times } from '../document/decimal';
import type { Key } from '../document/document';
import type { Reading } from '../document/reading';
import { dateIn, dateText } from './dates';

export interface TimeForm {
  readonly isExact: boolean; // decimals express all times of its cells
  /** The time of a cell; null where it is none. */
  read: (cell: string) => Decimal | null;
  /** The cell of a time, in the style of another cell; null where there is none. */
  write: (time: Decimal, like: string) => string | null;
}

const mostDigits = 37; // that times are read with
const longestTime = 60; // [characters]
const decimals = 18; // of the epoch and of cells that no decimal expresses
const exactly = 40; // decimals of times that no decimal expresses, so that differences are those that the library reads

function numeral(time: Decimal): string | null {
  const text = decimalText(time);
  const digits = text.replace(/[-.]/g, '').replace(/^0+/, '').length;
  return digits <= mostDigits && text.length <= longestTime ? text : null;
}

/** Of a unit that is a power of ten [s]. */
const ofPower = (power: number): TimeForm => ({
  isExact: true,
  read: (cell) => {
    const number = decimalOf(cell);
    return number && shifted(number, power);
  },
  write: (time) => numeral(shifted(time, -power)),
});

/** Of a unit that is a fraction [s]. */
const ofFraction = (numerator: Decimal, denominator: Decimal): TimeForm => ({
  isExact: false,
  read: (cell) => {
    const number = decimalOf(cell);
    return number && quotient(times(number, numerator), denominator, exactly);
  },
  write: (time) => numeral(quotient(times(time, denominator), numerator, decimals)),
});

const dates: TimeForm = {
  isExact: true,
  read: (cell) => dateIn(cell)?.seconds ?? null,
  write: (time, like) => {
    const found = dateIn(like);
    return found && dateText(time, found.style);
  },
};

const one = decimalOf('1')!;
const forms: readonly TimeForm[] = [dates, ...[0, -3, -6, -9].map(ofPower)];

/** Of a text such as `30000/1001`. */
const fractionOf = (text: string): (Decimal | null)[] => {
  const [numerator, denominator = '1'] = text.split('/');
  return [decimalOf(numerator), decimalOf(denominator)];
};

function statedForm({ options }: Reading): TimeForm | null {
  const [numerator, denominator] = fractionOf(String(options.fps ?? options.time_scale ?? ''));
  if (!numerator || !denominator) return null;
  return options.fps ? ofFraction(denominator, numerator) : ofFraction(numerator, denominator ?? one);
}

/** With it the cells say when the keys are that were read out of them; null where there is none. */
export function timeFormOf(cells: readonly string[], keys: readonly Key[], epoch: Decimal, reading: Reading): TimeForm | null {
  const stated = statedForm(reading);
  const fits = ({ read }: TimeForm): boolean => {
    const first = read(cells[0]);
    if (!first || !equal(quotient(first, one, decimals), quotient(epoch, one, decimals))) return false;
    return cells.every((cell, i) => {
      const time = read(cell);
      return time !== null && numberOf(difference(time, first)) === keys[i].t;
    });
  };
  return (stated ? [dates, stated] : forms).find(fits) ?? null;
}

/** Of a key, whose time counts from the first one that there was. */
export const textOfTime = (t: number, first: Decimal, form: TimeForm, like: string): string | null => form.write(sum(first, shortest(t)), like);
