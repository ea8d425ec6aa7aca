/**
 * What kind of thing went wrong: the keys, an argument, equations without a solution, a file, a task that was stopped, memory that ran out, a
 * fault of the library, an object that was disposed of, or what this browser lacks.
 */
export type ErrorCode = 'bad_data' | 'bad_argument' | 'not_converged' | 'bad_access' | 'cancelled' | 'no_memory' | 'fault' | 'disposed' | 'not_supported';
/** Where it went wrong, and what would mend it; each as far as there is one. */
export interface ErrorPlace {
    /** The key, from 0. */
    key?: number;
    /** Of the file, from 1. */
    line?: number;
    /** Of its table, from 1. */
    column?: number;
    /** The argument or option that is at fault. */
    option?: string;
    /** The option that would mend it. */
    remedy?: string;
}
/** What everything of this package throws. Its message is one sentence: what was found, and what was wanted. */
export declare class OrisplineError extends Error implements ErrorPlace {
    readonly name = "OrisplineError";
    readonly code: ErrorCode;
    readonly key?: number;
    readonly line?: number;
    readonly column?: number;
    readonly option?: string;
    readonly remedy?: string;
    constructor(code: ErrorCode, message: string, place?: ErrorPlace);
}
/** What was found, for a message. */
export declare const shown: (value: unknown) => string;
/** Options, which are an object or none. */
export declare const optionsOf: <Options extends object>(option: string, options: Options | null | undefined) => Partial<Options>;
/** A text of the caller. */
export declare const textOf: (option: string, text: string) => string;
/** An argument that cannot be: `found 7 numbers, wanted 12`. */
export declare const badArgument: (option: string, message: string) => OrisplineError;
