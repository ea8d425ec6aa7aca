// SPDX-License-Identifier: Apache-2.0
// What is plotted of a clip: how far all joints are off, and the chosen one.
import { once } from '../data/once';
import { isAlone, type Clip, type Skeleton } from '../data/report';
import { stepped } from '../look/number';
import type { Colours } from '../look/theme';
import { errorsOf, largestErrors, roundingsOf, stepOf, type Kind } from '../motion/poses';
import type { State } from '../store/store';
import { straight, type Line, type Quantity } from './quantity';

const largest = { angle_deg: once((clip: Clip) => largestErrors(clip, 'angle_deg')), distance: once((clip: Clip) => largestErrors(clip, 'distance')) };

function linesOf(skeleton: Skeleton, kind: Kind, { clip, joint }: State, colours: Colours): Line[] {
  const shown = skeleton.clips[clip];
  const { t } = shown.errors;
  if (t.length < 2) return [];
  const values = errorsOf(shown, kind, joint);
  const all: Line = { label: 'all joints', colour: kind === 'distance' ? colours.first : colours.reference, width: kind === 'distance' ? 2 : 1, ...straight(() => ({ t, values: largest[kind](shown) })) };
  const one: Line = { label: skeleton.joints[joint].name, colour: colours.second, width: kind === 'distance' ? 1.5 : 2, ...straight(() => ({ t, values })) };
  return kind === 'distance' ? [one, all] : [all, one];
}

/** Keys of the chosen joint are marked where its angle is. */
export function skeletonQuantities(skeleton: Skeleton): Quantity[] {
  const from = isAlone(skeleton) ? ' from where the clip begins' : '';
  const keys = ({ clip, joint }: State) => skeleton.clips[clip].joints[joint].key_t;
  const roundings = roundingsOf(skeleton);
  const text = (kind: Kind) => (value: number, { clip }: State) => stepped(value, stepOf(skeleton.clips[clip].errors, kind), roundings[kind]);
  return [
    {
      id: 'distance',
      title: `Shell distance${from} in the world`,
      unit: skeleton.unit,
      limit: skeleton.distance_limit ?? undefined,
      limitLabel: 'tolerance',
      keys: () => new Float64Array(),
      lines: (state, colours) => linesOf(skeleton, 'distance', state, colours),
      text: text('distance'),
    },
    {
      id: 'angle',
      title: `Angle${from} in the frame of the parent`,
      unit: 'deg',
      limit: skeleton.angle_limit ?? undefined,
      limitLabel: 'tolerance',
      keys,
      lines: (state, colours) => linesOf(skeleton, 'angle_deg', state, colours),
      text: text('angle_deg'),
    },
  ];
}
