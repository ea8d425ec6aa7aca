// SPDX-License-Identifier: Apache-2.0
// Everything: files in memory and tasks too.
import { Engine } from './engine.js';
import { FullOrispline } from './full_orispline.js';
import { System } from './system.js';
import { type LoadOptions, moduleOf } from './wasm.js';

export type { Motion, SampleOptions, Samples } from './curve.js';
export { type ErrorCode, type ErrorPlace, OrisplineError } from './errors.js';
export type { KeyFile, Options, Outcome, RunOptions, TaskInputs, Warning } from './full_orispline.js';
export type { KeyInfo, KeyTrack } from './key_track.js';
export type { KeyData, Order } from './keys.js';
export type { Setting, Settings } from './method.js';
export type { MethodInfo, ParameterInfo } from './orispline.js';
export type { Numbers, Playable } from './playable.js';
export type { Skeleton, SkeletonInfo } from './skeleton.js';
export type { InputsOf, OptionsOf, RateData, SceneFile } from './task_values.js';
export type { Tasks } from './task_types.js';
export type { BakedFile } from './player.js';
export type { Progress } from './system.js';
export type { Continuity, Jump, Peak, Peaks, WholeCurve as Curve } from './whole_curve.js';
export type { FullOrispline as Orispline, LoadOptions };

/** Loads the compiled code: of the file beside this script, or what the options say. */
export const load = async (options: LoadOptions = {}): Promise<FullOrispline> => {
  const module = await moduleOf(options, new URL('./full.wasm', import.meta.url)), system = new System();
  return new FullOrispline(new Engine(module, 'orispline_task_run_with', String, system), system);
};
