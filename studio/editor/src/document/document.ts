// SPDX-License-Identifier: Apache-2.0
// What is edited: keys, and the two methods whose curves go through them. Plain data; nothing in it is ever changed.
import type { Reading } from './reading';

export type Quaternion = readonly [w: number, x: number, y: number, z: number]; // of norm 1
export type Vector = readonly [x: number, y: number, z: number];

export interface Key {
  readonly id: number; // its own for as long as the document lives
  readonly row: number | null; // among the keys of the original file, from 0; null: it was made here
  readonly t: number; // [s], from the epoch of the file on
  readonly q: Quaternion; // body to world
  readonly p: Vector | null; // [m], world; all keys have one, or none has
  readonly rates: readonly Vector[]; // angular velocity [rad/s], acceleration, jerk, as far as the file has them; body
  readonly own: Readonly<Record<string, number>>; // its values of parameters such as `tension`; all keys have the same names
}

export type Setting = number | string | boolean;

/** A method with its settings. A parameter that the keys have values of their own for is not among them. */
export interface Choice {
  readonly method: string;
  readonly settings: Readonly<Record<string, Setting>>;
}

export interface StudioDocument {
  readonly version: 1;
  readonly keys: readonly Key[]; // times increase
  readonly first: Choice; // of the curve
  readonly second: Choice; // of that which it is compared with
}

export type Which = 'first' | 'second';

/** What was opened, as it was. */
export interface Original {
  readonly name: string; // of the file, such as `keys.csv`
  readonly text: string; // all of it; '' where it was no text
  readonly hash: string; // SHA-256 of its bytes, hexadecimal
  readonly epoch: string; // what times count from [s], exact
  readonly reading?: Reading; // what the user has said of it
}

/** What the page calls the two curves. */
export const names: Record<Which, string> = { first: 'Curve', second: 'Compare with' };

export const keyWith = ({ keys }: StudioDocument, id: number | null): Key | undefined => keys.find((key) => key.id === id);
