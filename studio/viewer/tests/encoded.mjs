// SPDX-License-Identifier: Apache-2.0
// Lists of numbers as the library writes them.

const base64 = (array) => Buffer.from(array.buffer).toString('base64');

export const f4 = (values) => ({ f4: base64(Float32Array.from(values, (value) => value ?? NaN)) });
export const f8 = (values) => ({ f8: base64(Float64Array.from(values, (value) => value ?? NaN)) });
export const u4 = (values, start, step) => ({ u4: base64(Uint32Array.from(values, (value) => Math.round((value - start) / step))), start, step });

/** Normal numbers of 1 at most; what is smaller than the least of them is 0. */
function half(value) {
  if (Number.isNaN(value)) return 0x7e00;
  const sign = value < 0 ? 0x8000 : 0;
  const size = Math.abs(value);
  if (size < 2 ** -14) return sign;
  const exponent = Math.floor(Math.log2(size));
  return sign + ((exponent + 15) << 10) + Math.round((size / 2 ** exponent - 1) * 1024); // a carry goes into the exponent
}

export function f2(values) {
  const unit = Math.max(...values.map((value) => Math.abs(value ?? 0))) || 1;
  return { f2: base64(Uint16Array.from(values, (value) => half((value ?? NaN) / unit))), unit };
}
