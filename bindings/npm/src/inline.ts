// SPDX-License-Identifier: Apache-2.0
// orispline/lite with its WebAssembly within the script, for bundlers that copy no file.
import { load as loadLite } from './lite.js';
import { moduleText } from './lite_module.js';
import type { Orispline } from './orispline.js';

export * from './lite.js';

/** Loads the compiled code of this script. */
export const load = (): Promise<Orispline> => loadLite({ wasm: Uint8Array.from(atob(moduleText), (letter) => letter.charCodeAt(0)) });
