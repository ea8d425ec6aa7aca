// SPDX-License-Identifier: Apache-2.0
// Orientations as numbers that people type.
import { exponential, logarithm } from 'orispline-viewer/motion/quaternion';
import type { Quaternion } from '../document/document';
import { notAQuaternion } from '../edits/reasons';
import { bodyOrders, fromEuler, toEuler, worldOrders } from './euler';

export interface Form {
  id: string; // such as `ZYX`
  title: string;
  names: string[];
  unit: string;
  step: number; // of an arrow key
  decimals: number; // that are shown
  keepsTyped: boolean; // several of its numbers are one orientation, so that what was typed is shown as it was
  numbersOf: (q: Quaternion) => number[];
  /** Of any norm; a sentence where the numbers are no orientation. */
  orientationOf: (numbers: number[]) => Quaternion | string;
}

const degree = Math.PI / 180;
const three = ([x, y, z]: number[], size: number): [number, number, number] => [x * size, y * size, z * size];

const ordinals = ['first', 'second', 'third'];

const euler = (order: string): Form => ({
  id: order,
  title: `Euler ${order}`,
  names: [...order].map((letter, i) => `${letter}, ${ordinals[i]} turn`),
  unit: '°',
  step: 1,
  decimals: 3,
  keepsTyped: true,
  numbersOf: (q) => three([...toEuler(order, q)], 1 / degree),
  orientationOf: (numbers) => fromEuler(order, three(numbers, degree)),
});

const quaternion: Form = {
  id: 'quaternion',
  title: 'Quaternion',
  names: ['qw', 'qx', 'qy', 'qz'],
  unit: '',
  step: 0.01,
  decimals: 6,
  keepsTyped: false,
  numbersOf: (q) => [...q],
  orientationOf: (numbers) => notAQuaternion(numbers) ?? (numbers as unknown as Quaternion),
};

const rotationVector: Form = {
  id: 'rotvec',
  title: 'Rotation vector',
  names: ['rx', 'ry', 'rz'],
  unit: 'rad',
  step: 0.01,
  decimals: 6,
  keepsTyped: true,
  numbersOf: (q) => logarithm([...q]),
  orientationOf: (numbers) => exponential(numbers as [number, number, number]),
};

export const groups: [title: string, forms: Form[]][] = [
  ['Numbers of a rotation', [quaternion, rotationVector]],
  ['Turns about the body’s axes', bodyOrders.map(euler)],
  ['Turns about the world’s axes', worldOrders.map(euler)],
];

export const formNamed = (id: string): Form => groups.flatMap(([, forms]) => forms).find((form) => form.id === id) ?? quaternion;
