// SPDX-License-Identifier: Apache-2.0
// The shortest text that reads back as the same number in the unit of a column. Null: there is none.
import { numberOf, numberText, shifted, shortest } from '../document/decimal';
import type { NumberColumn } from './columns';

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
