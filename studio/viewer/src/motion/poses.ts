// SPDX-License-Identifier: Apache-2.0
// Where joints are, and how far they are off, at any time of a clip.
import type { Numbers } from '../data/numbers';
import { once } from '../data/once';
import { isAlone, type Clip, type Errors, type Joint, type Poses, type Skeleton } from '../data/report';
import { fraction, spanAt } from './orientation';

/** x, y, z of every joint at every time. */
interface Places {
  before: Float32Array;
  after: Float32Array;
}

function decoded({ t, step, before, offset_step, after }: Poses): Places {
  const width = t.length > 0 ? before.length / t.length : 0;
  const places = { before: new Float32Array(before.length), after: new Float32Array(before.length) };
  const steps = before.slice(0, width);
  for (let i = 0; i < before.length; ++i) {
    if (i >= width) steps[i % width] += before[i];
    places.before[i] = step * steps[i % width];
    places.after[i] = places.before[i] + offset_step * (after[i] ?? 0);
  }
  return places;
}

export const placesOf = once(({ poses }: Clip) => decoded(poses));

/** The place in the list of times, with the part of the way to the next one. */
function between(t: Numbers, time: number): [index: number, part: number] {
  const i = spanAt(t, time);
  return [i, fraction(t, i, time)];
}

/** x, y, z of every joint at one time. */
export function placesAt(clip: Clip, which: keyof Places, time: number): Float32Array {
  const places = placesOf(clip)[which];
  const { t } = clip.poses;
  const width = places.length / t.length;
  const [i, part] = between(t, time);
  const [here, next] = [places.subarray(i * width, (i + 1) * width), places.subarray((i + 1) * width, (i + 2) * width)];
  return part > 0 ? here.map((value, k) => value + part * (next[k] - value)) : here.slice();
}

export type Kind = 'angle_deg' | 'distance';

/** What is smaller is rounding: about a millionth of what the clips take up, for that is 8000 steps. */
export const roundingsOf = once(({ clips }: Skeleton) => ({ angle_deg: 5e-5, distance: 0.008 * Math.max(...clips.map(({ poses }) => poses.step)) }));

/** In which the errors are whole numbers. */
export const stepOf = (errors: Errors, kind: Kind) => (kind === 'angle_deg' ? errors.angle_step : errors.distance_step);

/** Errors of a joint over the times of the clip's errors. */
export function errorsOf({ errors }: Clip, kind: Kind, joint: number): Float64Array {
  const steps = errors[kind][joint];
  return Float64Array.from(errors.t, (_, i) => (steps[i] ?? 0) * stepOf(errors, kind));
}

/** Of all joints together. */
export function largestErrors({ errors }: Clip, kind: Kind): Float64Array {
  const largest = new Float64Array(errors.t.length);
  for (const steps of errors[kind]) steps.forEach((value, i) => (largest[i] = Math.max(largest[i], value)));
  return largest.map((value) => value * stepOf(errors, kind));
}

/** The joint that is farthest off at the time that is nearest; nothing where none is off by more than the rounding. */
export function worstAt({ errors }: Clip, time: number, rounding: number): { joint: number; distance: number } | null {
  const [before, part] = between(errors.t, time);
  const i = before + Math.round(part);
  let worst: { joint: number; distance: number } | null = null;
  errors.distance.forEach((steps, joint) => {
    const distance = (steps[i] ?? 0) * errors.distance_step;
    if (distance > (worst?.distance ?? rounding)) worst = { joint, distance };
  });
  return worst;
}

/** The joint of a clip whose error is largest. */
export const worstJoint = ({ joints }: Clip, kind: Kind) => joints.reduce((worst, joint, i) => (joint[kind][0] > joints[worst][kind][0] ? i : worst), 0);

/** The joint that is chosen at first: of the one that is farthest off and those above it the nearest that turns by keys. */
export function firstJoint(skeleton: Skeleton, clip: Clip): number {
  const { joints } = skeleton;
  const worst = worstJoint(clip, 'distance');
  if (clip.joints[worst].distance[0] <= roundingsOf(skeleton).distance) return mostKeys(clip);
  const keysOf = (joint: number) => clip.joints[joint].keys[isAlone(skeleton) ? 0 : 1];
  for (let joint: number | null = worst; joint !== null; joint = joints[joint].parent) if (keysOf(joint) > 2) return joint;
  return worst;
}

const mostKeys = ({ joints }: Clip) => joints.reduce((most, { keys }, i) => (keys[0] > joints[most].keys[0] ? i : most), 0);

const stretching = 0.02; // of the longest distance
const many = 5;
const far = 0.2; // of the size of the skeleton

/** Of each joint the least and the largest distance from its parent; none where it has no parent. */
function lengthsOf(clip: Clip, joints: Joint[]): ([least: number, largest: number] | null)[] {
  const { before } = placesOf(clip);
  const width = 3 * joints.length;
  return joints.map(({ parent }, joint) => {
    if (parent === null) return null;
    const lengths = Float64Array.from(clip.poses.t, (_, i) => {
      const [from, to] = [i * width + 3 * parent, i * width + 3 * joint];
      return Math.hypot(before[to] - before[from], before[to + 1] - before[from + 1], before[to + 2] - before[from + 2]);
    });
    return [Math.min(...lengths), Math.max(...lengths)];
  });
}

/**
 * Of each joint, whether a bone leads to it: whether it stays in its distance from the parent. Where many joints hang on one,
 * those far from it are controls, such as of hands and feet.
 */
export function rigidJoints(clip: Clip, joints: Joint[], size: number): boolean[] {
  const children = joints.map((_, i) => joints.filter(({ parent }) => parent === i).length);
  return lengthsOf(clip, joints).map((length, joint) => {
    if (!length) return true;
    const [least, largest] = length;
    return largest - least <= stretching * largest && !(children[joints[joint].parent!] >= many && largest > far * size);
  });
}
