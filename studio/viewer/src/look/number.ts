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
