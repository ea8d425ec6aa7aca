// SPDX-License-Identifier: Apache-2.0
// Lists of numbers as a document has them: JSON arrays, or typed arrays in base64. What is not finite is NaN.

export type Numbers = Float32Array | Float64Array;

type Json = (number | null)[];

/** As the document has it; all typed arrays are little-endian. */
export type Encoded =
  | Json
  | { f4: string }
  | { f8: string }
  | { f2: string; unit: number } // half floats, in units
  | { u4: string; start: number; step: number }; // whole numbers, in steps from the start

function bytesOf(base64: string): ArrayBuffer {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** IEEE 754 binary16; what is not finite is NaN. */
function half(bits: number): number {
  const exponent = (bits >> 10) & 0x1f;
  const fraction = bits & 0x3ff;
  if (exponent === 0x1f) return NaN;
  const size = exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15);
  return bits & 0x8000 ? -size : size;
}

export function numbersOf(list: Encoded): Numbers {
  if (Array.isArray(list)) return Float64Array.from(list, (value) => value ?? NaN);
  if ('f4' in list) return new Float32Array(bytesOf(list.f4));
  if ('f8' in list) return new Float64Array(bytesOf(list.f8));
  if ('f2' in list) return Float32Array.from(new Uint16Array(bytesOf(list.f2)), (bits) => list.unit * half(bits));
  if ('u4' in list) return Float64Array.from(new Uint32Array(bytesOf(list.u4)), (n) => list.start + n * list.step);
  throw new Error(`found a list of numbers in a form that is not known: ${JSON.stringify(list).slice(0, 60)}`);
}
