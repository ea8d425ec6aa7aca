import { Orispline } from './orispline.js';
import { WholeCurve } from './whole_curve.js';
import { type LoadOptions } from './wasm.js';
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
export declare const load: (options?: LoadOptions) => Promise<Orispline<WholeCurve>>;
