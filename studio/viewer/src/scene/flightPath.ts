// SPDX-License-Identifier: Apache-2.0
// The positions of a motion in the units of its scene.
import { BufferGeometry, Line, LineBasicMaterial, Vector3 } from 'three';
import type { Numbers } from '../data/numbers';
import type { Keys, Method, Samples } from '../data/report';
import { vectorAt } from '../motion/orientation';

const vectors = (values: Numbers) => Array.from({ length: values.length / 3 }, (_, i) => new Vector3().fromArray(values, 3 * i));

/** Half of the keys are farther from the next one than this [m]. */
function medianStep({ p }: Keys): number {
  const keys = vectors(p);
  const steps = keys.slice(1).map((key, i) => key.distanceTo(keys[i]));
  return Math.max(steps.sort((a, b) => a - b)[steps.length >> 1] ?? 0, 1e-9);
}

export class FlightPath {
  private readonly samples: Samples;
  private readonly keys: Keys;
  private readonly center = new Vector3();
  private readonly extent: number; // [m]
  private readonly unit: number; // lengths of the scene per metre

  /** Scaled to a size as a whole, or so that neighbouring keys are as far from each other. */
  constructor(
    method: Method,
    scale: { whole: number } | { step: number },
  ) {
    this.samples = method.samples;
    this.keys = method.keys;
    const points = vectors(this.samples.p);
    const low = points.reduce((least, p) => least.min(p), points[0].clone());
    const high = points.reduce((most, p) => most.max(p), points[0].clone());
    this.center.addVectors(low, high).multiplyScalar(0.5);
    this.extent = Math.max(high.distanceTo(low), 1e-9);
    this.unit = 'whole' in scale ? scale.whole / this.extent : scale.step / medianStep(this.keys);
  }

  private at = (position: Vector3) => position.sub(this.center).multiplyScalar(this.unit);

  atTime = (t: number) => this.at(new Vector3(...vectorAt(this.samples.t, this.samples.p, t)));
  atKey = (key: number) => this.at(new Vector3().fromArray(this.keys.p, 3 * key));

  line = (colour: string) =>
    new Line(new BufferGeometry().setFromPoints(vectors(this.samples.p).map(this.at)), new LineBasicMaterial({ color: colour }));

  /** The shape of the path, in any size. */
  outline = (size: number) => vectors(this.samples.p).map((p) => this.at(p).multiplyScalar(size / (this.extent * this.unit)));
}
