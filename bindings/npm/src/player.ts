// SPDX-License-Identifier: Apache-2.0
// Plays what `orispline bake` writes. docs/bake.md describes the two formats.
import type { Numbers, Playable } from './playable.js';

export type { Numbers, Playable };

/** The content of a .json that `orispline bake` wrote. */
export interface BakedFile {
  orispline: string;
  version: number;
  /** Of the components: `xyzw`. */
  order: string;
  /** The time that the ends count from [s]. */
  epoch: number;
  /** From the curve, as it was found [rad]. */
  largest_difference: number;
  /** Of the pieces [s]. */
  ends: number[];
  /** Each has six coefficients of x, of y, of z and of w. */
  pieces: number[][];
}

interface Parts {
  epoch: number;
  ends: number[];
  coefficients: number[];
}

const version = 1, perPiece = 24;

const refuse = (found: string): never => {
  throw new Error(`orispline/player: found ${found}, wanted version ${version} of what 'orispline bake' writes`);
};

/** Bytes in a memory of their own, where numbers of 8 bytes lie at multiples of 8; nothing of what has none. Buffers may be those of another realm, such as that of a frame. */
const bytesOf = (file: unknown): ArrayBuffer | undefined => {
  try {
    const view = ArrayBuffer.isView(file) ? file : new DataView(file as ArrayBuffer);
    return new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice().buffer;
  } catch {
    return undefined;
  }
};

const partsOfBytes = (bytes: ArrayBuffer): Parts => {
  if (bytes.byteLength < 32 || String.fromCharCode(...new Uint8Array(bytes, 0, 8)) !== 'ORIBAKED') refuse('other bytes');
  const [found, count] = new Uint32Array(bytes, 8, 2), start = 40 + 8 * count;
  if (found !== version) refuse(`version ${found}`);
  if (!count || bytes.byteLength !== start + 4 * perPiece * count) refuse(`${bytes.byteLength} bytes for ${count} pieces`);
  return { epoch: new Float64Array(bytes, 16, 1)[0], ends: [...new Float64Array(bytes, 32, count + 1)], coefficients: [...new Float32Array(bytes, start)] };
};

const partsOfFile = (file: BakedFile): Parts => {
  if (file?.orispline !== 'baked') refuse('another object');
  const { order, epoch, ends, pieces } = file;
  if (file.version !== version) refuse(`version ${file.version}`);
  if (order !== 'xyzw') refuse(`the order ${order}`);
  if (![ends, pieces].every(Array.isArray)) refuse('no lists of ends and pieces');
  const all = pieces.flat(), wanted = perPiece * (ends.length - 1);
  if (!wanted || all.length !== wanted || pieces.some((piece) => piece?.length !== perPiece)) refuse(`${all.length} coefficients for ${ends.length} ends`);
  return { epoch, ends, coefficients: all };
};

/** A curve that plays the content of a .json, parsed, or the bytes of a .bin. It gives x, y, z, w. */
export const player = (file: BakedFile | ArrayBuffer | ArrayBufferView): Playable => {
  const bytes = bytesOf(file), { epoch, ends, coefficients } = bytes ? partsOfBytes(bytes) : partsOfFile(file as BakedFile);
  const c = Float32Array.from(coefficients), last = ends.length - 1, start = epoch + ends[0], end = epoch + ends[last];
  // Twice the span too, of which the places on the pieces are made.
  if (![2 * (ends[last] - ends[0]), start, end, epoch, ...ends, ...coefficients, ...c].every(Number.isFinite)) refuse('what is no finite number');
  // Pieces follow each other, but for the one of a single key, which has no length.
  if (ends.some((end, i) => (ends[2] === undefined ? end < ends[i - 1] : end <= ends[i - 1]))) refuse('ends that do not increase');
  let piece = 0; // the one of the last time, near which the next one is
  return {
    start,
    end,
    at<Target extends Numbers = number[]>(time: number, target = [] as Numbers as Target): Target {
      if (typeof time !== 'number' || Object(target) !== target)
        throw new Error(`orispline/player: found the time ${String(time)} and a target that is ${typeof target}, wanted a number and an array`);
      const t = Math.min(Math.max(time - epoch, ends[0]), ends[last]);
      if (t < ends[piece] || t >= ends[piece + 1]) {
        let low = 0, high = last;
        while (high - low > 1) {
          const middle = (low + high) >> 1;
          if (ends[middle] <= t) low = middle;
          else high = middle;
        }
        piece = low;
      }
      const from = ends[piece], s = (2 * (t - from)) / (ends[piece + 1] - from || 1) - 1;
      for (let i = 0, k = perPiece * piece; i < 4; ++i, k += 6)
        target[i] = ((((c[k + 5] * s + c[k + 4]) * s + c[k + 3]) * s + c[k + 2]) * s + c[k + 1]) * s + c[k];
      return target;
    },
  };
};
