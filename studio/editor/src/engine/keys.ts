// SPDX-License-Identifier: Apache-2.0
// Keys as the library has them, and as the document does.
import type { KeyData } from 'orispline/keys';
import type { KeyTrack } from 'orispline/key_track';
import type { Key, Quaternion, Vector } from '../document/document';

const rates = ['angularVelocities', 'angularAccelerations', 'angularJerks'] as const;

/** Row after row. */
function flat(keys: readonly Key[], width: number, rowOf: (key: Key) => readonly number[]): Float64Array {
  const numbers = new Float64Array(width * keys.length);
  keys.forEach((key, k) => numbers.set(rowOf(key), width * k));
  return numbers;
}

export function dataOf(keys: readonly Key[]): KeyData {
  const data: KeyData = { times: flat(keys, 1, ({ t }) => [t]), orientations: flat(keys, 4, ({ q }) => q), order: 'wxyz' };
  if (keys[0]?.p) data.positions = flat(keys, 3, ({ p }) => p ?? []);
  for (const [k, name] of rates.entries()) if (keys[0]?.rates[k]) data[name] = flat(keys, 3, (key) => key.rates[k]);
  return data;
}

const row = (numbers: ArrayLike<number>, width: number, k: number): number[] => Array.from({ length: width }, (_, i) => numbers[width * k + i]);

/** The keys of a file, with the columns that are to be their own. `isOriginal`: they are the rows of the file. */
export function keysIn(track: KeyTrack, own: readonly string[], isOriginal: boolean): Key[] {
  const data = track.data('wxyz'), columns = own.map((name) => [name, track.column(name)] as const);
  return Array.from(data.times, (t, k) => ({
    id: k,
    row: isOriginal ? k : null,
    t,
    q: row(data.orientations, 4, k) as unknown as Quaternion,
    p: data.positions ? (row(data.positions, 3, k) as unknown as Vector) : null,
    rates: rates.flatMap((name) => (data[name] ? [row(data[name], 3, k) as unknown as Vector] : [])),
    own: Object.fromEntries(columns.map(([name, values]) => [name, values[k]])),
  }));
}
