// SPDX-License-Identifier: Apache-2.0
// A report from the JSON document that the library writes, which studio/report/README.md describes.
import { numbersOf, type Encoded, type Numbers } from './numbers';
import { reportOf, type Band, type Clip, type Keys, type Marks, type Method, type Path, type Report, type Samples, type Skeleton } from './report';

/** What is read. Version 1 has no member `data`. */
export const newestData = 2;

/** What the document has instead of a list of numbers, all through it. */
type Written<T> = T extends Numbers ? Encoded : T extends object ? { [Name in keyof T]: Written<T[Name]> } : T;

/** A list that the method of that number has too. */
type Shared = Encoded | { like: number };

/** Optional members came with later versions, or are left out where there is nothing to say. */
type WrittenSamples = Omit<Written<Samples>, 't' | 'error_t' | 'straight' | 'exactness_deg'> & { t: Shared; error_t: Shared; straight?: boolean; exactness_deg?: number | null };
type WrittenMethod = Omit<Written<Method>, 'samples' | 'keys' | 'bands' | 'clock'> & {
  samples: WrittenSamples;
  keys: Written<Keys> | null;
  bands?: Record<string, Written<Band>>;
  clock?: Written<Method['clock']>;
};
export type ReportDocument = Partial<Omit<Written<Report>, 'methods'>> & { data?: number; methods?: WrittenMethod[] };

const pathOf = ({ t, q }: Written<Path>): Path => ({ t: numbersOf(t), q: numbersOf(q) });
const keysOf = (keys: Written<Keys>): Keys => ({ ...pathOf(keys), p: numbersOf(keys.p) });
const marksOf = (marks: Written<Marks>): Marks => ({ ...pathOf(marks), label: marks.label, error_deg: numbersOf(marks.error_deg) });
const bandOf = ({ label, t, low, high }: Written<Band>): Band => ({ label, t: numbersOf(t), low: numbersOf(low), high: numbersOf(high) });

const samplesOf = (samples: WrittenSamples, t: Numbers, error_t: Numbers): Samples => ({
  t,
  q: numbersOf(samples.q),
  w: numbersOf(samples.w),
  a: numbersOf(samples.a),
  j: numbersOf(samples.j),
  torque: numbersOf(samples.torque),
  p: numbersOf(samples.p),
  error_t,
  error_deg: numbersOf(samples.error_deg),
  straight: samples.straight ?? false,
  exactness_deg: samples.exactness_deg ?? null,
});

const areEqual = (some: Numbers, others: Numbers) => some.length === others.length && some.every((value, i) => value === others[i]);

/** The times of each method: those that are equal are one list, so that their lines need not be joined. */
function timesOf(written: Shared[]): Numbers[] {
  const times: Numbers[] = [];
  for (const shared of written) {
    const list = 'like' in shared ? times[shared.like] : numbersOf(shared);
    if (!list) throw new Error('found times that are like those of a later method');
    times.push(times.find((other) => areEqual(other, list)) ?? list);
  }
  return times;
}

function methodsOf(methods: WrittenMethod[], ofAll: Keys): Method[] {
  const times = timesOf(methods.map(({ samples }) => samples.t));
  const errorTimes = timesOf(methods.map(({ samples }) => samples.error_t));
  return methods.map(({ samples, keys, bands = {}, clock = null, ...method }, i) => ({
    ...method,
    samples: samplesOf(samples, times[i], errorTimes[i]),
    keys: keys ? keysOf(keys) : ofAll,
    bands: Object.fromEntries(Object.entries(bands).map(([id, band]) => [id, bandOf(band)])),
    clock: clock && { t: numbersOf(clock.t), own: numbersOf(clock.own) },
  }));
}

const clipOf = ({ poses, errors, joints, ...clip }: Written<Clip>): Clip => ({
  ...clip,
  poses: { ...poses, t: numbersOf(poses.t), before: numbersOf(poses.before), after: numbersOf(poses.after) },
  errors: { ...errors, t: numbersOf(errors.t), angle_deg: errors.angle_deg.map(numbersOf), distance: errors.distance.map(numbersOf) },
  joints: joints.map((joint) => ({ ...joint, key_t: numbersOf(joint.key_t) })),
});

const skeletonOf = ({ clips, unit, ...skeleton }: Written<Skeleton>): Skeleton => ({ ...skeleton, unit: unit || 'units', clips: clips.map(clipOf) });

/** Throws a sentence where it cannot be read. */
export function readDocument({ data = 1, keys, reference, marks, methods, skeleton, ...rest }: ReportDocument): Report {
  if (data > newestData) throw new Error(`found data of version ${data}, wanted version ${newestData} or an older one`);
  const ofAll = keysOf(keys ?? { t: [], q: [], p: [] });
  return reportOf({
    ...rest,
    keys: ofAll,
    reference: reference ? pathOf(reference) : null,
    marks: marks ? marksOf(marks) : null,
    methods: methodsOf(methods ?? [], ofAll),
    skeleton: skeleton ? skeletonOf(skeleton) : null,
  });
}
