// SPDX-License-Identifier: Apache-2.0
import { curedOnPage, remedyIn } from './cures';
import type { Trouble } from './protocol';

/** What an error says, as plain data. */
export function troubleOf(reason: unknown): Trouble {
  const { message, key, line, column, option, remedy = remedyIn(message ?? '') } = reason as Trouble;
  const trouble: Trouble = { message: curedOnPage(message || String(reason)) };
  if (key !== undefined) trouble.key = key;
  if (line !== undefined) trouble.line = line;
  if (column !== undefined) trouble.column = column;
  if (option !== undefined) trouble.option = option;
  if (remedy !== undefined) trouble.remedy = remedy;
  return trouble;
}
