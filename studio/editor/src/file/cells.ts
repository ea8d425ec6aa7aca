// SPDX-License-Identifier: Apache-2.0
// What stands in the cells of a key: the shortest texts that read back as the same numbers. Null: there is none.
import { type Decimal, decimalOf, decimalText, difference, equal, numberOf, numberText, shifted, shortest, sum } from '../document/decimal';
import type { Key } from '../document/document';
import type { NumberColumn } from './columns';

const mostDigits = 37; // that times are read with
const longestTime = 60; // [characters]
const powers = [0, -3, -6, -9]; // of ten, of the units of times [s]
const tries = 4; // units in the last place, to either side

function neighbour(value: number, steps: number): number {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, value);
  bits.setBigInt64(0, bits.getBigInt64(0) + BigInt(steps));
  return bits.getFloat64(0);
}

/** Of a number in the unit of its column. */
export function textInUnit(value: number, { numerator, denominator }: NumberColumn): string | null {
  if (numerator === denominator) return numberText(value);
  const power = Math.round(Math.log10(denominator / numerator));
  const near = numberOf(shifted(shortest(value), power));
  for (let step = 0; step <= tries; step++)
    for (const candidate of [neighbour(near, step), neighbour(near, -step)]) if ((candidate * numerator) / denominator === value) return numberText(candidate);
  return null;
}

/** The power of ten that the unit of a column of times is [s]: with it the cells say when the keys are that were read out of them. */
export function unitOfTimes(cells: readonly string[], keys: readonly Key[], epoch: Decimal): number | null {
  const times = cells.map(decimalOf);
  const fits = (power: number): boolean =>
    times.every((time, i) => time !== null && numberOf(difference(shifted(time, power), epoch)) === keys[i].t) && equal(shifted(times[0]!, power), epoch);
  return powers.find(fits) ?? null;
}

/** Of a time from the epoch on, exact. */
export function textOfTime(t: number, epoch: Decimal, power: number): string | null {
  const time = shifted(sum(epoch, shortest(t)), -power);
  const text = decimalText(time);
  const digits = text.replace(/[-.]/g, '').replace(/^0+/, '').length;
  return digits <= mostDigits && text.length <= longestTime ? text : null;
}
