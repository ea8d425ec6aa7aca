// SPDX-License-Identifier: Apache-2.0
// What the page asks of the worker, which has the library, and what it is told. Lists of vectors and quaternions (w, x, y, z) are flat.
import type { MethodInfo as LibraryMethod, ParameterInfo } from 'orispline/orispline';
import type { Choice, Key, Original, Quaternion, StudioDocument, Vector, Which } from '../document/document';
import type { Form } from '../document/form';
import type { Reading } from '../document/reading';

/** A sentence of the library, with the place that it is about. */
export interface Trouble {
  message: string;
  key?: number; // index
  line?: number; // of the file
  column?: number; // of its table, from 1
  option?: string;
  remedy?: string; // what the user may say of the file so that it is read: an option of the library, such as `fps`
}

/** Even samples, and both sides of every key between the ends, by time. */
export interface Samples {
  t: Float64Array; // [s]
  q: Float64Array; // w, x, y, z; body to world
  w: Float64Array; // [rad/s], body
  a: Float64Array; // [rad/s²]
  j: Float64Array; // [rad/s³]
  p: Float64Array; // [m], world; empty where keys have none
  orders: Int8Array; // of each key: no rate up to this order jumps there; -1: the orientation itself does. The ends have 3.
}

export type Drawn = Samples | { trouble: Trouble };

/** Curves of both choices. */
export type Curves = Record<Which, Drawn>;

export interface Opened {
  original: Original;
  document: StudioDocument;
  warnings: Warning[];
}

/** A sentence, and the option of the library that says something of the file, where that would change it. */
export type Warning = Pick<Trouble, 'message' | 'remedy'>;

/** More keys than can be edited. */
export interface TooMany {
  original: Original;
  count: number;
  hasPositions: boolean;
}

/** The keys that a recording needs. */
export interface Reduced {
  count: number;
  method: string; // they are for it
  others: { method: string; count: number }[]; // what other methods need
  furthest: number; // from a sample that was reduced, at most [deg]
  furthestPosition: number | null; // [m]
  smoothed: { noise: number; rms: number } | null; // what was smoothed first: the noise per axis, and the samples as they were from the curve [deg]
  opened: Opened | null; // null: more than can be edited
}

export type { ParameterInfo };

/** Another method, and what its curve does that was measured. */
export interface Remedy {
  choice: Choice;
  own: [name: string, from: string][]; // values at keys that it has besides, and those that they shall be like
  turn: number; // [rad]
  order: number; // no rate up to it jumps at a key
  apart: number | null; // [rad] at most from the curve in whose place it comes, both with the keys at even times; null: not asked
}

/** What the library says of a method. */
export interface MethodInfo extends LibraryMethod {
  interpolates: boolean;
  support_keys: number | null; // on which a piece of a curve depends; null: on all
  choices: { name: string; words: string[]; default?: string }[];
}

/** Why there is no answer to what was asked before `stop`. */
export const stopped: Trouble = { message: 'It was stopped.' };

export const mostKeys = 1000; // that can be edited

/** A file as it is opened. */
export interface Source {
  bytes: Uint8Array;
  name: string;
  reading?: Reading;
  hash?: string; // of the file on the disk, where these bytes are what was made of it
}

/** What can be asked, by name: of each what is given, and what is told. All are promises on the page; errors are `Trouble`. */
export interface Questions {
  methods: { given: null; told: MethodInfo[] };
  /** `method` and `beside`: the texts of both methods; without them that which the file is for, and slerp. */
  open: { given: Source & { method?: string; beside?: string }; told: Opened | TooMany };
  /** Of a recording those keys that are needed; tolerances with their units, such as `0.1deg`. `methods`: texts with commas between them. */
  reduce: { given: Source & { tolerance: string; positionTolerance?: string; smooth?: boolean; methods?: string }; told: Reduced };
  /** Only the latest one is answered; others are never told. `count` samples at even times. */
  curves: { given: { document: StudioDocument; count: number }; told: Curves };
  /** A calm method for keys with which that of a choice turns too far; they turn by `need` [rad]. */
  calmest: { given: { keys: readonly Key[]; choice: Choice; need: number }; told: Remedy | null };
  /** For a method that is smooth on even times only, one that is so on any. */
  ofAnyTimes: { given: { keys: readonly Key[]; choice: Choice }; told: Remedy | null };
  /** Where the curve of a choice is at a time. */
  at: { given: { keys: readonly Key[]; choice: Choice; time: number }; told: { q: Quaternion; p: Vector | null } };
  /** All keys as a file of the library, such as `keys.csv`, which states the method too. */
  write: { given: { keys: readonly Key[]; epoch: string; name: string; choice: Choice | null }; told: string };
  /** What the library reads out of a file, to be compared with what was to be written. */
  read: { given: { text: string; name: string; reading?: Reading }; told: readonly Key[] };
  /** Whether the file is opened with this choice for A, and with these values of the keys' own. */
  reopens: { given: { text: string; name: string; reading?: Reading; choice: Choice; own: readonly Key['own'][] }; told: boolean };
  /** Cells that state orientations in another form, like those that stand there now, and how far what is read of them is from the orientation, by its components. */
  stated: { given: { orientations: readonly Quaternion[]; form: Form; beside: readonly (readonly number[])[] }; told: readonly { texts: string[]; off: number }[] };
  /** Rows of samples at a step [s], or so many at even times. */
  sample: { given: { keys: readonly Key[]; choice: Choice; count: number; rates: 0 | 1 | 2 | 3 }; told: Omit<Samples, 'orders'> };
  /** For `orispline/player`, as JSON; the tolerance in rad. */
  bake: { given: { keys: readonly Key[]; choice: Choice; tolerance: number }; told: string };
}

export type Name = keyof Questions;
export type Given<N extends Name> = Questions[N]['given'];
export type Told<N extends Name> = Questions[N]['told'];

/** The worker, as the page sees it. */
export interface Engine {
  /** `progress` is told the share of a long task that is done, from 0 to 1. */
  ask<N extends Exclude<Name, 'curves'>>(name: N, given: Given<N>, progress?: (share: number) => void): Promise<Told<N>>;
  /** Ends what is being done; who waits for it is told `stopped`. */
  stop(): void;
  /** Draws the newest document, again and again; calls back with the curves of one that was newest when its turn came. */
  draw(document: StudioDocument): void;
  onCurves(listener: (curves: Curves, of: StudioDocument) => void): void;
  close(): void;
}
