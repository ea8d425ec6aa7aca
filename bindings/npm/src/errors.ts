// SPDX-License-Identifier: Apache-2.0

/**
 * What kind of thing went wrong: the keys, an argument, equations without a solution, a file, a task that was stopped, memory that ran out, a
 * fault of the library, an object that was disposed of, or what this browser lacks.
 */
export type ErrorCode =
  | 'bad_data' | 'bad_argument' | 'not_converged' | 'bad_access' | 'cancelled' | 'no_memory' | 'fault' | 'disposed' | 'not_supported';

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
export class OrisplineError extends Error implements ErrorPlace {
  override readonly name = 'OrisplineError';
  readonly code: ErrorCode;
  declare readonly key?: number;
  declare readonly line?: number;
  declare readonly column?: number;
  declare readonly option?: string;
  declare readonly remedy?: string;

  constructor(code: ErrorCode, message: string, place: ErrorPlace = {}) {
    super(message);
    this.code = code;
    Object.assign(this, place);
  }
}

/** What was found, for a message. */
export const shown = (value: unknown): string => {
  if (typeof value === 'number' || value === undefined) return String(value);
  try {
    const text = JSON.stringify(value);
    if (text.length < 80) return text;
  } catch {
    // A BigInt, a function, a symbol, or an object that holds one or itself.
  }
  return `something of the type ${typeof value}`;
};

/** Options, which are an object or none. */
export const optionsOf = <Options extends object>(option: string, options: Options | null | undefined): Partial<Options> => {
  if (typeof (options ?? {}) !== 'object') throw badArgument(option, `found ${shown(options)}, wanted an object`);
  return options ?? {};
};

/** A text of the caller. */
export const textOf = (option: string, text: string): string => {
  if (typeof text !== 'string') throw badArgument(option, `found ${shown(text)}, wanted a text`);
  return text;
};

/** An argument that cannot be: `found 7 numbers, wanted 12`. */
export const badArgument = (option: string, message: string): OrisplineError =>
  new OrisplineError('bad_argument', `${option}: ${message}`, { option });
