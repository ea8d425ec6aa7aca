// SPDX-License-Identifier: Apache-2.0
import type { Address, Engine } from './engine.js';
import { textOf } from './errors.js';
import { type Options, withOptions } from './options.js';

/** What is to be said of a result; docs/inspect-json.md has all members. */
export interface Warning {
  code: string;
  message: string;
  key?: number;
  line?: number;
  [number: string]: unknown;
}

/** A file that was written. */
export interface KeyFile {
  bytes: Uint8Array;
  warnings: Warning[];
}

/** What a function writes of a handle, as a file of that name. */
export const written = (engine: Engine, call: string, handle: Address, name: string, options: Options): KeyFile => {
  const sizeAt = engine.numbersAt, warningsAt = sizeAt + 8;
  return engine.withText(textOf('name', name), (text) => withOptions(engine, options, (list, count) => {
    engine.check(call, handle, text, list, count, engine.handleAt, sizeAt, warningsAt);
    const [at, size, warnings] = [engine.handleAt, sizeAt, warningsAt].map((place) => engine.address(place));
    try {
      return { bytes: engine.bytes(at, size).slice(), warnings: JSON.parse(engine.text(warnings)) };
    } finally {
      engine.free('orispline_text_free', at);
      engine.free('orispline_text_free', warnings);
    }
  }));
};
