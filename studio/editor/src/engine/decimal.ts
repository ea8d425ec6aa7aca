// SPDX-License-Identifier: Apache-2.0
// Numbers as the decimals that they are written as: their sums are exact.

export interface Decimal {
  digits: bigint;
  exponent: number; // of ten, of the last digit
}

/** Of a number, or of a text that is one. */
export function decimalOf(number: number | string): Decimal {
  const [mantissa, exponent = '0'] = String(number).toLowerCase().split('e');
  const [whole, fraction = ''] = mantissa.split('.');
  return { digits: BigInt(whole + fraction), exponent: Number(exponent) - fraction.length };
}

export function sumOf(a: Decimal, b: Decimal): Decimal {
  const exponent = Math.min(a.exponent, b.exponent);
  const shifted = (one: Decimal): bigint => one.digits * 10n ** BigInt(one.exponent - exponent);
  return { digits: shifted(a) + shifted(b), exponent };
}

export const negativeOf = ({ digits, exponent }: Decimal): Decimal => ({ digits: -digits, exponent });

/** A text that is this very number. */
export const textOf = ({ digits, exponent }: Decimal): string => `${digits}e${exponent}`;

/** The nearest double. */
export const numberOf = (decimal: Decimal): number => Number(textOf(decimal));
