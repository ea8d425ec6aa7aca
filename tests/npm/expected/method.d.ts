/** A setting of a method: a number, one for each key, a word, or three numbers of a rate. `closed: true` makes a loop. */
export type Setting = number | string | boolean | ArrayLike<number> | undefined;
/** By the names of docs/families, in either way of writing: `startRate` is `start_rate`. */
export type Settings = Record<string, Setting>;
/** The text of a method, as the library reads it: `timed-c2:tension=0.5,1,0.5:closed`. */
export declare const methodText: (method: string, settings: Settings) => string;
