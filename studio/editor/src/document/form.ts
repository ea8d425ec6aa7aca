// SPDX-License-Identifier: Apache-2.0
// The forms beside unit quaternions in which files state orientations, as docs/files.md names them.

export type AngleUnit = 'deg' | 'rad' | 'mrad' | 'arcsec';

export type Form =
  | { readonly kind: 'euler'; readonly order: string; readonly unit: AngleUnit } // three angles in the order of the turns
  | { readonly kind: 'rotvec'; readonly unit: AngleUnit } // axis times angle
  | { readonly kind: 'matrix' }; // body to world, row by row

/** A full turn in a unit. */
export const fullTurn: Readonly<Record<AngleUnit, number>> = { deg: 360, rad: 2 * Math.PI, mrad: 2000 * Math.PI, arcsec: 1296000 };
