// SPDX-License-Identifier: Apache-2.0
// Colours, told apart by every eye, on light and on dark ground.

export interface Colours {
  first: string;
  second: string;
  reference: string;
  limit: string;
  mark: string;
  x: string;
  y: string;
  z: string;
  ink: string;
  faint: string;
  grid: string;
  ground: string;
}

const light: Colours = {
  first: '#0072b2',
  second: '#b84a00',
  reference: '#7a7f87',
  limit: '#b3261e',
  mark: '#b3261e',
  x: '#b5179e',
  y: '#008060',
  z: '#a87900',
  ink: '#1d2329',
  faint: '#5b6570',
  grid: '#e3e7eb',
  ground: '#ffffff',
};

const dark: Colours = {
  first: '#56b4e9',
  second: '#ff9a4d',
  reference: '#9aa3ad',
  limit: '#ff7b6e',
  mark: '#ff7b6e',
  x: '#e58ad6',
  y: '#3cc9a0',
  z: '#e6c229',
  ink: '#e8ecf0',
  faint: '#a3adb8',
  grid: '#2b333c',
  ground: '#161b21',
};

export const coloursOf = ({ theme }: { theme: 'light' | 'dark' }): Colours => (theme === 'dark' ? dark : light);
