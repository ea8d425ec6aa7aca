// SPDX-License-Identifier: Apache-2.0
// Four methods in the least space: auto, slerp, squad, timed-c2.
import { Curve } from './curve.js';
import { Engine } from './engine.js';
import { methods } from './lite_methods.js';
import { type MethodInfo, Orispline } from './orispline.js';
import { sentence } from './sentence.js';
import { type LoadOptions, moduleOf } from './wasm.js';

export type { Motion, SampleOptions, Samples } from './curve.js';
export { type ErrorCode, type ErrorPlace, OrisplineError } from './errors.js';
export type { KeyData, Order } from './keys.js';
export type { Setting, Settings } from './method.js';
export type { ParameterInfo } from './orispline.js';
export type { Numbers, Playable } from './playable.js';
export type { Curve, LoadOptions, MethodInfo, Orispline };

/** Loads the compiled code: of the file beside this script, or what the options say. */
export const load = async (options: LoadOptions = {}): Promise<Orispline> =>
  new Orispline(new Engine(await moduleOf(options, new URL('./lite.wasm', import.meta.url)), 'orispline_curve_motion', sentence), Curve, () => structuredClone(methods));
