// SPDX-License-Identifier: Apache-2.0
// The data of a report with plain lists of numbers, as pages had them before their data were typed.

const sizes = { f2: 2, f4: 4, f8: 8, u4: 4 };

function half(bits) {
  const [sign, exponent, fraction] = [bits & 0x8000 ? -1 : 1, (bits >> 10) & 0x1f, bits & 0x3ff];
  if (exponent === 0x1f) return fraction ? NaN : sign * Infinity;
  return exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

const read = {
  f2: (view, at, { unit = 1 }) => unit * half(view.getUint16(at, true)),
  f4: (view, at) => view.getFloat32(at, true),
  f8: (view, at) => view.getFloat64(at, true),
  u4: (view, at, { start, step }) => start + step * view.getUint32(at, true),
};

function numbers(list, type) {
  const bytes = Buffer.from(list[type], 'base64');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Array.from({ length: bytes.length / sizes[type] }, (_, i) => {
    const value = read[type](view, i * sizes[type], list);
    return Number.isFinite(value) ? value : null;
  });
}

/** The same document; JSON of it is what a page of data version 1 reads. */
export function plain(document) {
  const walk = (value) => {
    if (Array.isArray(value)) return value.map(walk);
    if (value === null || typeof value !== 'object') return value;
    const type = Object.keys(sizes).find((name) => typeof value[name] === 'string');
    if (type) return numbers(value, type);
    return Object.fromEntries(Object.entries(value).map(([name, member]) => [name, walk(member)]));
  };
  const made = walk(document);
  for (const { samples } of made.methods ?? []) if (samples.t?.like !== undefined) samples.t = made.methods[samples.t.like].samples.t;
  delete made.data;
  return made;
}
