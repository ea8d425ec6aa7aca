// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.

/** Four significant digits; a dash where there is no number. */
export function shown(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-3)) return value.toExponential(2).replace('e+', 'e').replace('-', '−');
  return value.toLocaleString('en-GB', { maximumSignificantDigits: 4, useGrouping: false }).replace('-', '−');
}

export const seconds = (value: number) => `${value.toFixed(2)} s`.replace('-', '−');
