import type { Orispline } from './orispline.js';
export * from './lite.js';
/** Loads the compiled code of this script. */
export declare const load: () => Promise<Orispline>;
