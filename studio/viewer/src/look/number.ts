// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.

/** Four significant digits, whole numbers from a thousand on; a dash where there is no number, 0 where it is rounding. */
export function shown(value: number | null | undefined, rounding = 0): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size <= rounding) return '0';
  if (size >= 1e5 || size < 1e-3) return value.toExponential(2).replace('e+', 'e').replaceAll('-', '−');
  const text = size >= 1000 ? value.toFixed(0) : value.toPrecision(4);
  return text.replace('-', '−');
}

/** A number that somebody chose, as it was chosen. */
export const chosen = (value: number) => String(Number(value.toPrecision(5))).replaceAll('-', '−');

/** Beside an axis, where there is little room. */
export function tick(value: number): string {
  const size = Math.abs(value);
  const text = size >= 1e4 || (size < 1e-3 && size > 0) ? Number(value.toPrecision(6)).toExponential().replace('e+', 'e') : String(value);
  return text.replaceAll('-', '−');
}

/** The largest of 1, 2 and 5 times a power of ten that is not larger. */
export function roundStep(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  return power * (size >= 5 * power ? 5 : size >= 2 * power ? 2 : 1);
}

/** The digits of a number, such as ² */
export const raised = (digits: string) => [...digits].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('');

/** Units and names as they are printed: `rad/s^2` and `rad/s2` as rad/s². */
export const typeset = (text: string) => text.replace(/\|/g, '\u2060|\u2060').replace(/\^k\b/g, 'ᵏ').replace(/(?<=[a-z])\^?([23])(?![\w.])/g, (_, digit) => raised(digit));

/** 10⁻³; nothing for 10⁰. */
export const powerOfTen = (exponent: number) =>
  exponent === 0 ? '' : `10${exponent < 0 ? '⁻' : ''}${raised(String(Math.abs(exponent)))}`;

const leastDigits = 4; // of the smallest number of a column
const mostDecimals = 5;
const mostDigits = 8; // of the largest number

const magnitudeOf = (value: number) => Math.floor(Math.log10(value));

/** Numbers below each other, in a power of a thousand that they share where it is needed, their decimal points below each other. */
export class NumberColumn {
  readonly exponent: number;
  private readonly decimals: number;

  /** Of what is not larger than the rounding, 0 is shown. */
  constructor(
    values: (number | null | undefined)[],
    private readonly rounding = 0,
  ) {
    const sizes = values.filter((value): value is number => typeof value === 'number' && Number.isFinite(value)).map(Math.abs).filter((size) => size > rounding);
    const [least, most] = sizes.length > 0 ? [Math.min(...sizes), Math.max(...sizes)] : [1, 1];
    const fits = most < 1e5 && leastDigits - 1 - magnitudeOf(least) <= mostDecimals;
    this.exponent = fits ? 0 : 3 * Math.floor(magnitudeOf(most) / 3);
    const [lowest, highest] = [least, most].map((size) => magnitudeOf(size) - this.exponent);
    this.decimals = Math.max(0, Math.min(leastDigits - 1 - lowest, mostDecimals, mostDigits - 1 - Math.max(highest, 0)));
  }

  text(value: number | null | undefined): string {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    if (Math.abs(value) <= this.rounding) return '0';
    const text = (value / 10 ** this.exponent).toFixed(this.decimals);
    const isTooSmall = value !== 0 && Number(text) === 0;
    return (isTooSmall ? `<${(10 ** -this.decimals).toFixed(this.decimals)}` : text).replace('-', '−');
  }
}

/** A number of whole steps, with no more digits than the step allows; 0 where it is rounding. */
export function stepped(value: number, step: number, rounding = 0): string {
  if (Math.abs(value) <= rounding) return '0';
  const decimals = Math.min(Math.max(0, Math.floor(-Math.log10(step))), 9);
  return (Math.round(value / step) * step).toFixed(decimals).replace('-', '−');
}
