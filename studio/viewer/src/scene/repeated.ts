// SPDX-License-Identifier: Apache-2.0
// Many equal shapes in one geometry: graphics without an accelerator draw instances one by one, each of which takes as long as a whole line.
import { BufferAttribute, type BufferGeometry, type TypedArray } from 'three';

function copied({ array, itemSize }: { array: TypedArray; itemSize: number }, values: Float32Array | Uint32Array, shift = 0): BufferAttribute {
  for (let i = 0; i < values.length; ++i) values[i] = array[i % array.length] + shift * Math.floor(i / array.length);
  return new BufferAttribute(values, itemSize);
}

/** Gives a geometry the triangles and some attributes of a shape, so many times. */
export function repeat(shape: BufferGeometry, times: number, names: string[], geometry: BufferGeometry): void {
  const index = shape.index!;
  geometry.setIndex(copied(index, new Uint32Array(times * index.count), shape.getAttribute('position').count));
  for (const name of names) {
    const attribute = shape.getAttribute(name) as BufferAttribute;
    geometry.setAttribute(name, copied(attribute, new Float32Array(times * attribute.array.length)));
  }
}
