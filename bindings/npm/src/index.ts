// SPDX-License-Identifier: Apache-2.0
// All methods, samples in bulk, what curves are worth, and baking.
import { Engine } from './engine.js';
import { Orispline } from './orispline.js';
import { System } from './system.js';
import { WholeCurve } from './whole_curve.js';
import { type LoadOptions, moduleOf } from './wasm.js';

export type { Motion, SampleOptions, Samples } from './curve.js';
export { type ErrorCode, type ErrorPlace, OrisplineError } from './errors.js';
export type { KeyData, Order } from './keys.js';
export type { Setting, Settings } from './method.js';
export type { MethodInfo, ParameterInfo } from './orispline.js';
export type { Numbers, Playable } from './playable.js';
export type { BakedFile } from './player.js';
export type { Continuity, Jump, Peak, Peaks } from './whole_curve.js';
export type { LoadOptions, Orispline, WholeCurve as Curve };

/** Loads the compiled code: of the file beside this script, or what the options say. */
export const load = async (options: LoadOptions = {}): Promise<Orispline<WholeCurve>> => {
  const engine = new Engine(await moduleOf(options, new URL('./orispline.wasm', import.meta.url)), 'orispline_sample_even', String, new System());
  return new Orispline(engine, WholeCurve, () => JSON.parse(engine.toldText('orispline_methods_json')));
};
