// SPDX-License-Identifier: Apache-2.0
// From the world of a clip to the space of the scene: z up, the skeleton two units tall, its middle in the origin.
import { Vector3 } from 'three';
import type { Clip, Skeleton } from '../../data/report';
import { roundStep } from '../../look/number';
import { placesOf } from '../../motion/poses';

const tall = 2;
const longestPath = 16; // of the whole path; what is longer is drawn smaller
const nearFloor = 0.15; // of the height: the floor is at 0 where the lowest joint is so near to it
const mostPoses = 60; // of the outline
const squares = 4; // of the floor, along the height

type Box = { low: Vector3; high: Vector3 };

const emptyBox = (): Box => ({ low: new Vector3(Infinity, Infinity, Infinity), high: new Vector3(-Infinity, -Infinity, -Infinity) });

function take(box: Box, place: Vector3): void {
  box.low.min(place);
  box.high.max(place);
}

const sizeOf = ({ low, high }: Box) => high.clone().sub(low);

/** Of all joints, on the floor. */
function centreOf(places: Float32Array): Vector3 {
  const sum = new Vector3();
  for (let i = 0; i < places.length; i += 3) sum.add(new Vector3(places[i], places[i + 1], 0));
  return sum.divideScalar(places.length / 3);
}

export class Space {
  readonly unit: number; // lengths of the scene in one of the world
  readonly square: number; // of the floor, in the world
  readonly floor: number; // height in the scene
  readonly path: Box; // of the whole clip in the scene
  readonly outline: Vector3[]; // what the picture is to hold
  private readonly shift = new Vector3(); // of the middle of that
  readonly height: number;
  private readonly yIsUp: boolean;
  private readonly middle: Vector3; // in the world, turned

  constructor(skeleton: Skeleton, clip: Clip, isWhole: boolean) {
    this.yIsUp = skeleton.up === 'y';
    const { before, after } = placesOf(clip);
    const width = 3 * skeleton.joints.length;
    const all = this.boxOf(before, after);
    const first = sizeOf(this.boxOf(before.subarray(0, width)));
    const size = Math.max(first.x, first.y, first.z) || sizeOf(all).length() || 1;
    const lengths = sizeOf(all);
    const reach = Math.max(lengths.x, lengths.y, lengths.z);
    this.unit = isWhole ? Math.min(tall / size, longestPath / reach) : tall / size;
    this.height = this.unit * size;
    const floor = Math.abs(all.low.z) < nearFloor * size ? 0 : all.low.z;
    this.middle = all.low.clone().add(all.high).multiplyScalar(0.5).setZ(floor + size / 2);
    if (isWhole) this.middle.z = (floor + all.high.z) / 2;
    this.floor = this.unit * (floor - this.middle.z);
    this.square = roundStep(size / squares);
    this.path = { low: this.inScene(all.low), high: this.inScene(all.high) };
    this.outline = this.outlineOf(before, width, isWhole);
  }

  /** Joints at some times: where they are, or around their centre, which moves along. */
  private outlineOf(all: Float32Array, width: number, isWhole: boolean): Vector3[] {
    const points: Vector3[] = [];
    const times = all.length / width;
    const every = Math.ceil(times / mostPoses);
    for (let i = 0; i < times; i += every) {
      const places = this.shown(all.subarray(i * width, (i + 1) * width));
      const centre = isWhole ? new Vector3() : centreOf(places);
      for (let k = 0; k < width; k += 3) points.push(new Vector3().fromArray(places, k).sub(centre));
    }
    const box = emptyBox();
    for (const point of points) take(box, point);
    this.shift.addVectors(box.low, box.high).multiplyScalar(0.5);
    return points.map((point) => point.sub(this.shift));
  }

  /** Where all of the scene is to be put at a time, so that the outline is around the origin. */
  origin(places: Float32Array, isWhole: boolean): Vector3 {
    const centre = isWhole ? new Vector3() : centreOf(places);
    return centre.add(this.shift).negate();
  }

  private turned(x: number, y: number, z: number): Vector3 {
    return this.yIsUp ? new Vector3(x, -z, y) : new Vector3(x, y, z);
  }

  private inScene = (world: Vector3) => world.clone().sub(this.middle).multiplyScalar(this.unit);

  private boxOf(...lists: Float32Array[]): Box {
    const box = emptyBox();
    for (const list of lists)
      for (let i = 0; i < list.length; i += 3) take(box, this.turned(list[i], list[i + 1], list[i + 2]));
    return box;
  }

  /** Places of the world in the scene. */
  shown(places: Float32Array): Float32Array {
    const shown = new Float32Array(places.length);
    for (let i = 0; i < places.length; i += 3) this.inScene(this.turned(places[i], places[i + 1], places[i + 2])).toArray(shown, i);
    return shown;
  }
}
