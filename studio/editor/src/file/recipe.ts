// SPDX-License-Identifier: Apache-2.0
// The comment above the keys that names the method they are for.
import type { Choice } from '../document/document';
import { methodText, sameMethod } from '../document/methodText';
import { tableOf, type Line } from './table';

const comment = /^([ \t]*#[ \t]*orispline:(?:.*[ \t])?method=)([^ \t]+)(.*)$/;
const anyOf = /^([ \t]*#[ \t]*orispline:)(.*)$/; // it may say other things of the keys alone, such as gaps

function changedLine(line: Line, choice: Choice): string | null {
  const [, start, method, rest] = comment.exec(line.text) ?? [];
  if (method !== undefined) return rest.includes('blending=') || sameMethod(method, methodText(choice)) ? null : start + methodText(choice) + rest;
  const [, mark, words] = anyOf.exec(line.text) ?? [];
  return mark === undefined ? null : `${mark} method=${methodText(choice)}${words}`;
}

/** The text with the method of a choice in that comment, which is put above all else where there is none. Where there are several, or functions of one's own, the text stays. */
export function withRecipe(text: string, choice: Choice): string {
  const table = tableOf(text);
  if (!table) return text;
  const stated = table.lines.slice(0, table.rows[0]).filter((line) => anyOf.test(line.text));
  if (stated.length > 1) return text;
  const [line] = stated, end = table.lines.find((one) => one.end !== '')?.end ?? '\n';
  if (!line) return `${table.mark}# orispline: method=${methodText(choice)}${end}${text.slice(table.mark.length)}`;
  const changed = changedLine(line, choice);
  return changed === null ? text : table.mark + table.lines.map((other) => (other === line ? changed : other.text) + other.end).join('');
}
