// SPDX-License-Identifier: Apache-2.0
import { curedOnPage } from './cures';
import type { Trouble } from './protocol';

/** What an error says, as plain data. */
export function troubleOf(reason: unknown): Trouble {
  const { message, key, line, column, option, remedy } = reason as Trouble & { remedy?: string };
  const trouble: Trouble = { message: curedOnPage(message || String(reason), remedy) };
  if (key !== undefined) trouble.key = key;
  if (line !== undefined) trouble.line = line;
  if (column !== undefined) trouble.column = column;
  if (option !== undefined) trouble.option = option;
  return trouble;
}
