// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.

/** Four significant digits, whole numbers from a thousand on; a dash where there is no number. */
export function shown(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-3)) return value.toExponential(2).replace('e+', 'e').replace('-', '−');
  const text = size >= 1000 || value === 0 ? value.toFixed(0) : value.toPrecision(4);
  return text.replace('-', '−');
}

/** Beside an axis, where there is little room. */
export function tick(value: number): string {
  const size = Math.abs(value);
  const text = size >= 1e4 || (size < 1e-3 && size > 0) ? Number(value.toPrecision(6)).toExponential().replace('e+', 'e') : String(value);
  return text.replaceAll('-', '−');
}

export const seconds = (value: number) => `${value.toFixed(2)} s`.replace('-', '−');
