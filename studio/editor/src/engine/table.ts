// SPDX-License-Identifier: Apache-2.0
import { decimalOf, decimalText, shortest, sum } from '../document/decimal';
import type { Choice, Key } from '../document/document';
import { methodText } from '../document/methodText';

const rateNames = [['wx', 'wy', 'wz'], ['ax', 'ay', 'az'], ['jx', 'jy', 'jz']];

/** Keys as a CSV that the library reads: with all digits, the times with the epoch, and the method that they are for. */
export function tableOf(keys: readonly Key[], epoch: string, choice: Choice | null): string {
  const [key] = keys, from = decimalOf(epoch)!;
  const names = ['t', 'qw', 'qx', 'qy', 'qz', ...(key.p ? ['px', 'py', 'pz'] : []), ...rateNames.slice(0, key.rates.length).flat(), ...Object.keys(key.own)];
  const rows = keys.map(({ t, q, p, rates, own }) => [decimalText(sum(from, shortest(t))), ...q, ...(p ?? []), ...rates.flat(), ...Object.values(own)].join());
  return [...(choice ? [`# orispline: method=${methodText(choice)}`] : []), names.join(), ...rows, ''].join('\n');
}
