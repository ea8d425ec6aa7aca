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
  /** From the path, as it was found [m]; this and what follows stand in version 2, which has positions. */
  largest_position_difference?: number;
  /** Of the pieces of positions [s]. */
  position_ends?: number[];
  /** Each has six coefficients of x, of y and of z. */
  position_pieces?: number[][];
}

/** A baked curve that plays. */
export interface Player extends Playable {
  /** Whether the file has positions. */
  readonly hasPositions: boolean;
  /** Writes the position [m] at a time [s] into `target` and returns it; outside it is that of the end, of NaN it is NaN. */
  positionAt<Target extends Numbers = number[]>(time: number, target?: Target): Target;
}

/** Polynomials with six coefficients for each of `width` components, between ends [s]. */
interface Pieces {
  width: number;
  ends: number[];
  coefficients: number[];
}

interface Parts {
  epoch: number;
  turns: Pieces;
  path?: Pieces;
}

const powers = 6, quaternion = 4, vector = 3;

const refuse = (found: string): never => {
  throw new Error(`orispline/player: found ${found}, wanted version 1 or 2 of what 'orispline bake' writes`);
};

const checkVersion = (found: number): void => {
  if (found !== 1 && found !== 2) refuse(`version ${found}`);
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
  if (bytes.byteLength < 40 || String.fromCharCode(...new Uint8Array(bytes, 0, 8)) !== 'ORIBAKED') refuse('other bytes');
  const [version, count] = new Uint32Array(bytes, 8, 2), parts: Parts = { epoch: new Float64Array(bytes, 16, 1)[0], turns: { width: quaternion, ends: [], coefficients: [] } };
  checkVersion(version);
  let at = 32;
  const take = <Kind extends Float32Array | Float64Array>(kind: { new (bytes: ArrayBuffer, at: number, count: number): Kind; BYTES_PER_ELEMENT: number }, length: number, count: number): number[] => {
    const from = at;
    at += kind.BYTES_PER_ELEMENT * length;
    if (!count || at > bytes.byteLength) refuse(`${bytes.byteLength} bytes for ${count} pieces`);
    return [...new kind(bytes, from, length)];
  };
  parts.turns.ends = take(Float64Array, count + 1, count);
  parts.turns.coefficients = take(Float32Array, powers * quaternion * count, count);
  if (version === 2 && at + 16 <= bytes.byteLength) {
    const [count] = new Uint32Array(bytes, at, 1);
    at += 16;
    const ends = take(Float64Array, count + 1, count), firsts = take(Float64Array, vector * count, count), others = take(Float32Array, (powers - 1) * vector * count, count);
    parts.path = { width: vector, ends, coefficients: firsts.flatMap((first, k) => [first, ...others.slice((powers - 1) * k, (powers - 1) * (k + 1))]) };
  }
  if (at !== bytes.byteLength || !parts.path !== (version === 1)) refuse(`${bytes.byteLength} bytes for ${count} pieces`);
  return parts;
};

const piecesOf = (ends: number[], pieces: number[][], width: number): Pieces => {
  if (![ends, pieces].every(Array.isArray)) refuse('no lists of ends and pieces');
  const coefficients = pieces.flat(), perPiece = powers * width, wanted = perPiece * (ends.length - 1);
  if (!wanted || coefficients.length !== wanted || pieces.some((piece) => piece?.length !== perPiece)) refuse(`${coefficients.length} coefficients for ${ends.length} ends`);
  return { width, ends, coefficients };
};

const partsOfFile = (file: BakedFile): Parts => {
  if (file?.orispline !== 'baked') refuse('another object');
  const { order, epoch, version } = file;
  checkVersion(version);
  if (order !== 'xyzw') refuse(`the order ${order}`);
  const parts: Parts = { epoch, turns: piecesOf(file.ends, file.pieces, quaternion) };
  if (version === 2) parts.path = piecesOf(file.position_ends!, file.position_pieces!, vector);
  return parts;
};

/** Writes the values at a time [s] into a target. */
const evaluatorOf = ({ width, ends, coefficients }: Pieces, epoch: number) => {
  // In single precision, but for where positions are.
  const c = Float64Array.from(coefficients, (number, k) => (width === vector && k % powers === 0 ? number : Math.fround(number))), last = ends.length - 1;
  // Twice the span too, of which the places on the pieces are made.
  if (![2 * (ends[last] - ends[0]), ...ends, ...coefficients, ...c].every(Number.isFinite)) refuse('what is no finite number');
  // Pieces follow each other, but for the one of a single key, which has no length.
  if (ends.some((end, i) => (ends[2] === undefined ? end < ends[i - 1] : end <= ends[i - 1]))) refuse('ends that do not increase');
  let piece = 0; // the one of the last time, near which the next one is
  return <Target extends Numbers>(time: number, target: Target): Target => {
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
    for (let i = 0, k = powers * width * piece; i < width; ++i, k += powers)
      target[i] = ((((c[k + 5] * s + c[k + 4]) * s + c[k + 3]) * s + c[k + 2]) * s + c[k + 1]) * s + c[k];
    return target;
  };
};

/** A curve that plays the content of a .json, parsed, or the bytes of a .bin. It gives x, y, z, w. */
export const player = (file: BakedFile | ArrayBuffer | ArrayBufferView): Player => {
  const bytes = bytesOf(file), { epoch, turns, path } = bytes ? partsOfBytes(bytes) : partsOfFile(file as BakedFile);
  const turn = evaluatorOf(turns, epoch), place = path && evaluatorOf(path, epoch), ends = [turns, path ?? turns];
  const start = epoch + Math.min(...ends.map(({ ends }) => ends[0])), end = epoch + Math.max(...ends.map(({ ends }) => ends.at(-1)!));
  if (![start, end, epoch].every(Number.isFinite)) refuse('what is no finite number');
  return {
    start,
    end,
    hasPositions: !!place,
    at: <Target extends Numbers = number[]>(time: number, target = [] as Numbers as Target) => turn(time, target),
    positionAt<Target extends Numbers = number[]>(time: number, target = [] as Numbers as Target): Target {
      if (!place) throw new Error("orispline/player: found a file without positions, wanted what 'orispline bake' writes of keys that have them");
      return place(time, target);
    },
  };
};
