// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { type Forgotten, Held } from './held.js';
import type { Options } from './options.js';
import { type KeyFile, type Warning, written } from './written.js';

/** What a skeleton is. */
export interface SkeletonInfo {
  /** Of its file. */
  name: string;
  /** `gltf` or `bvh`. */
  format: string;
  joints: string[];
  clips: string[];
  /** Of reading its file. */
  warnings: Warning[];
}

/** A skeleton with its clips, as a task has made it. It is freed as a `KeyTrack` is. */
export class Skeleton extends Held {
  /** Of an `Orispline`, by its `run`. */
  constructor(engine: Engine, forgotten: Forgotten, address: Address) {
    super(engine, forgotten, 'skeleton', address);
  }

  get info(): SkeletonInfo {
    return JSON.parse(this.engine.toldText('orispline_value_json', this.handle));
  }

  /** A file of it, whose name says of which format: `.glb`, `.gltf` or `.bvh`. What its own file held besides is passed on where the format is the same. */
  write(name: string, options: Options = {}): KeyFile {
    return written(this.engine, 'orispline_value_write', this.handle, name, options);
  }
}
