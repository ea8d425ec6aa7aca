// SPDX-License-Identifier: Apache-2.0
// The positions of a motion in the units of its scene.
import { Vector3 } from 'three';
import type { Numbers } from '../data/numbers';
import type { Keys, Method, Samples } from '../data/report';
import { vectorAt } from '../motion/orientation';
import { thinned } from './thinned';

const mostOutline = 400; // points of an outline
const unseen = 1e-3; // length of the scene, a tenth of a pixel

const resting = 1e-6; // of the size of a path, or of a metre: what moves less stands still

/** Of the steps from key to key that are longer than this half are longer [m]; a metre where there are none. */
function medianStep({ p }: Keys, least: number): number {
  const steps = Float64Array.from({ length: Math.max(p.length / 3 - 1, 0) }, (_, i) => Math.hypot(p[3 * i + 3] - p[3 * i], p[3 * i + 4] - p[3 * i + 1], p[3 * i + 5] - p[3 * i + 2]));
  const moving = steps.filter((step) => step > least).sort();
  return moving[moving.length >> 1] ?? 1;
}

/** The least and the largest of each coordinate. */
function boxOf(p: Numbers): [low: Vector3, high: Vector3] {
  const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
  for (let i = 0; i < p.length; i += 3) {
    const point = new Vector3().fromArray(p, i);
    if (!Number.isNaN(point.x)) (low.min(point), high.max(point));
  }
  return [low, high];
}

export class FlightPath {
  readonly unit: number; // lengths of the scene per metre
  readonly line: Float32Array; // x, y, z of so many points that no eye misses one
  readonly low: number; // height in the scene of its lowest point
  private readonly samples: Samples;
  private readonly keys: Keys;
  private readonly centre = new Vector3();

  /** Scaled to a size as a whole, or so that neighbouring keys are as far from each other. */
  constructor({ samples, keys }: Method, scale: { whole: number } | { step: number }) {
    this.samples = samples;
    this.keys = keys;
    const [low, high] = boxOf(samples.p);
    this.centre.addVectors(low, high).multiplyScalar(0.5);
    const size = high.distanceTo(low);
    const extent = size > resting ? size : 1;
    this.unit = 'whole' in scale ? scale.whole / extent : scale.step / medianStep(keys, resting * extent);
    this.low = this.unit * (low.z - this.centre.z);
    this.line = thinned(this.points(), unseen);
  }

  /** Of a position [m], which becomes its place in the scene. */
  at = (position: Vector3) => position.sub(this.centre).multiplyScalar(this.unit);

  atTime = (t: number) => this.at(new Vector3(...vectorAt(this.samples.t, this.samples.p, t)));
  atKey = (key: number) => this.at(new Vector3().fromArray(this.keys.p, 3 * key));

  /** x, y, z of all samples. */
  private points(): Float32Array {
    const points = new Float32Array(this.samples.p.length);
    const centre = this.centre.toArray();
    for (let i = 0; i < points.length; ++i) points[i] = this.unit * (this.samples.p[i] - centre[i % 3]);
    return points;
  }

  /** The shape of the path. */
  outline(): Vector3[] {
    const points = this.line;
    const every = 3 * Math.ceil(points.length / 3 / mostOutline);
    return Array.from({ length: Math.ceil(points.length / every) }, (_, i) => new Vector3().fromArray(points, every * i)).filter(({ x }) => !Number.isNaN(x));
  }
}
