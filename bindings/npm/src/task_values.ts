// SPDX-License-Identifier: Apache-2.0
import type { KeyTrack } from './key_track.js';
import type { KeyData } from './keys.js';
import type { Options } from './options.js';
import type { Skeleton } from './skeleton.js';
import type { Tasks } from './task_types.js';

/** The rates of a gyro on a clock of its own. */
export interface RateData {
  /** [s], increasing. */
  times: ArrayLike<number>;
  /** Three numbers a time [rad/s], in the frame of the gyro. */
  rates: ArrayLike<number>;
  /** What the times count from [s], a decimal number, such as the `epoch` of the keys' `info`; nothing: 0. */
  epoch?: string | undefined;
}

/** A file of a skeleton with its clips. */
export interface SceneFile {
  /** A glTF file has to hold its data, as `.glb` does. */
  bytes: ArrayBuffer | ArrayBufferView | string;
  /** It says what the bytes are: `walk.glb`, `walk.gltf`, `walk.bvh`. */
  name: string;
  /** Those that are meant; nothing: all. */
  clips?: string[] | undefined;
  /** Keeps the first of keys at equal times. */
  dropDuplicates?: boolean | undefined;
  /** Takes the whole frames of a BVH file that was cut off. */
  salvage?: boolean | undefined;
  /** The frame of a BVH file, from 0, whose pose is the rest pose; nothing: that of its offsets, with no turns. */
  restFrame?: number | undefined;
  /** Whether cubic rotations whose signs flip go the short way, or as their signs say; nothing: that, with a warning. */
  signs?: 'shortest' | 'as-given' | undefined;
}

export type KeyInput = KeyData | KeyTrack;
export type RateInput = RateData;
export type SceneInput = SceneFile | Skeleton;
export type TaskInput = KeyInput | RateInput | SceneInput;

/** What tasks take, by the names that they have for it; several where a task takes several. */
export type TaskInputs = Record<string, TaskInput | TaskInput[] | undefined>;

/** `max_rate` as scripts spell it: `maxRate`. */
type Spelt<Name> = Name extends `${infer First}_${infer Rest}` ? `${First}${Capitalize<Spelt<Rest>>}` : Name;
type BothSpelt<Members> = Members & { [Name in keyof Members as Spelt<Name> & string]?: Members[Name] };

/** The inputs and the options of a task of that name; of a name that is known at run time alone, any. */
export type InputsOf<Task extends string> = Task extends keyof Tasks ? Tasks[Task]['inputs'] : string extends Task ? TaskInputs : never;
export type OptionsOf<Task extends string> = Task extends keyof Tasks ? BothSpelt<Tasks[Task]['options']> : string extends Task ? Options : never;
