// SPDX-License-Identifier: Apache-2.0
// The comment above the keys that names the method they are for. It is written only where the file has one already.
import type { Choice } from '../document/document';
import { methodText, sameMethod } from '../document/methodText';
import { tableOf } from './table';

const comment = /^([ \t]*#[ \t]*orispline:(?:.*[ \t])?method=)([^ \t]+)(.*)$/;

/** The text with the method of a choice in that comment. Where there is none, or several, or functions of one's own, the text stays. */
export function withRecipe(text: string, choice: Choice): string {
  const table = tableOf(text);
  if (!table) return text;
  const stated = table.lines.slice(0, table.rows[0]).filter((line) => comment.test(line.text));
  if (stated.length !== 1) return text;
  const [line] = stated;
  const [, start, method, rest] = comment.exec(line.text)!;
  if (rest.includes('blending=') || sameMethod(method, methodText(choice))) return text;
  const changed = { ...line, text: start + methodText(choice) + rest };
  return table.mark + table.lines.map((other) => (other === line ? changed.text + changed.end : other.text + other.end)).join('');
}
