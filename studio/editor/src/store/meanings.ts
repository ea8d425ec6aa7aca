// SPDX-License-Identifier: Apache-2.0
// What values at keys do, in a sentence: docs/families tells more. A method that is not named has the meaning of the name.
import type { ParameterInfo } from '../engine/protocol';

const rests = '0 rests at the key, a larger one passes it faster and looser.';
const opposite = '1 rests at the key, 0 passes it as usual, below 0 faster: the opposite of the tension of other methods.';

const meanings: Readonly<Record<string, string>> = {
  tension: rests,
  tension1: rests,
  tension2: 'How much the curve bends at the key; 0 takes the bend away.',
  'tcb tension': opposite,
  'tcb continuity': '0 is smooth; any other value makes a corner at the key.',
  'tcb bias': 'Above 0 the step before the key counts more, below 0 the step behind it.',
  nu: '0 is usual; a larger one pulls the curve tighter at the key.',
  beta1: '1 is usual; any other value leans the curve to one side of the key.',
  beta2: '0 is usual; a larger one pulls the curve tighter to the key.',
};

/** Where nothing is known but its default. */
export function meaningOf(method: string, { name, default: usual }: ParameterInfo): string {
  return meanings[`${method} ${name}`] ?? meanings[name] ?? `${Number(usual.toPrecision(4))} is usual.`;
}
