// SPDX-License-Identifier: Apache-2.0
// Decimal numbers, exact: times of today in nanoseconds have more digits than a double.

export interface Decimal {
  readonly digits: bigint;
  readonly exponent: number; // the value is digits · 10^exponent
}

const form = /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/;
const largestExponent = 400; // of a double, and more

/** What a text says; null where it is no decimal number. */
export function decimalOf(text: string): Decimal | null {
  const found = form.exec(text);
  if (!found) return null;
  const [, sign, whole, fraction, power = '0'] = found;
  const exponent = Number(power) - fraction.length;
  if (whole + fraction === '' || Math.abs(exponent) > largestExponent) return null;
  const size = BigInt(whole + fraction);
  return { digits: sign === '-' ? -size : size, exponent };
}

/** The shortest decimal that reads back as the same double. */
export const shortest = (number: number): Decimal => decimalOf(String(number))!;

const scaled = ({ digits, exponent }: Decimal, to: number): bigint => digits * 10n ** BigInt(exponent - to);

function combined(one: Decimal, other: Decimal, combine: (a: bigint, b: bigint) => bigint): Decimal {
  const exponent = Math.min(one.exponent, other.exponent);
  return { digits: combine(scaled(one, exponent), scaled(other, exponent)), exponent };
}

export const sum = (one: Decimal, other: Decimal): Decimal => combined(one, other, (a, b) => a + b);
export const difference = (one: Decimal, other: Decimal): Decimal => combined(one, other, (a, b) => a - b);
export const equal = (one: Decimal, other: Decimal): boolean => difference(one, other).digits === 0n;

export const times = (one: Decimal, other: Decimal): Decimal => ({ digits: one.digits * other.digits, exponent: one.exponent + other.exponent });

/** With so many decimals, of which the last is rounded, halves away from zero. */
export function quotient(one: Decimal, other: Decimal, decimals: number): Decimal {
  const power = one.exponent - other.exponent + decimals;
  const [over, under] = power >= 0 ? [one.digits * 10n ** BigInt(power), other.digits] : [one.digits, other.digits * 10n ** BigInt(-power)];
  const size = (number: bigint): bigint => (number < 0n ? -number : number);
  const digits = (2n * size(over) + size(under)) / (2n * size(under));
  return { digits: over < 0n === under < 0n ? digits : -digits, exponent: -decimals };
}

/** Times a power of ten. */
export const shifted = ({ digits, exponent }: Decimal, by: number): Decimal => ({ digits, exponent: exponent + by });

/** Its digits, without an exponent and without zeros at the end of a fraction. */
export function decimalText(decimal: Decimal): string {
  const sign = decimal.digits < 0n ? '-' : '';
  const digits = (decimal.digits < 0n ? -decimal.digits : decimal.digits).toString();
  if (decimal.exponent >= 0) return decimal.digits === 0n ? '0' : sign + digits + '0'.repeat(decimal.exponent);
  const padded = digits.padStart(1 - decimal.exponent, '0');
  const fraction = padded.slice(decimal.exponent).replace(/0+$/, '');
  const whole = padded.slice(0, decimal.exponent);
  return (decimal.digits === 0n ? '' : sign) + whole + (fraction && `.${fraction}`);
}

/** The nearest double. */
export const numberOf = ({ digits, exponent }: Decimal): number => Number(`${digits}e${exponent}`);

/** The shortest text that reads back as the same double, for files; free rates have no number. */
export const numberText = (value: number): string => (Object.is(value, -0) ? '-0' : Number.isNaN(value) ? 'nan' : String(value));
