// SPDX-License-Identifier: Apache-2.0
// The methods of A and B, and their settings.
import type { Choice, Setting, StudioDocument, Which } from '../document/document';

/** What a method knows, as the library tells it. */
export interface Known {
  readonly name: string;
  readonly parameters: readonly { readonly name: string; readonly min: number; readonly max: number }[];
  readonly choices: readonly { readonly name: string; readonly values: readonly string[] }[];
  readonly ends: readonly string[];
  readonly closes: boolean;
}

/** A rule for both ends, or one for each: `rest`, `natural,clamped`. */
export const endsOf = (text: string): string[] => text.split(',');

/** Whether a method has such a setting, and may have this value of it. */
export function knows(method: Known, name: string, value: Setting): boolean {
  if (name === 'closed') return method.closes && typeof value === 'boolean';
  if (name === 'ends') return typeof value === 'string' && endsOf(value).length <= 2 && endsOf(value).every((end) => method.ends.includes(end));
  if (name === 'period') return method.closes && typeof value === 'number' && value > 0;
  if (name === 'start_rate' || name === 'end_rate') return method.ends.includes('clamped') && typeof value === 'string';
  const parameter = method.parameters.find((candidate) => candidate.name === name);
  if (parameter) return typeof value === 'number' && parameter.min <= value && value <= parameter.max;
  return typeof value === 'string' && (method.choices.find((candidate) => candidate.name === name)?.values.includes(value) ?? false);
}

/** Another method. Settings that it knows are kept; others are dropped. */
export function withMethod(document: StudioDocument, which: Which, method: Known): StudioDocument {
  const choice: Choice = document[which];
  if (choice.method === method.name) return document;
  const settings = Object.fromEntries(Object.entries(choice.settings).filter(([name, value]) => knows(method, name, value)));
  return { ...document, [which]: { method: method.name, settings } };
}

/** One setting, or without a value the method's own again. One that the method refuses changes nothing, nor does one that keys have of their own. */
export function withSetting(document: StudioDocument, which: Which, method: Known, name: string, value?: Setting): StudioDocument {
  const choice: Choice = document[which];
  if (choice.method !== method.name || choice.settings[name] === value) return document;
  const { [name]: _, ...others } = choice.settings;
  if (value === undefined) return { ...document, [which]: { ...choice, settings: others } };
  const isOwn = document.keys.some(({ own }) => name in own);
  return isOwn || !knows(method, name, value) ? document : { ...document, [which]: { ...choice, settings: { ...choice.settings, [name]: value } } };
}

/** A and B in each other's place. */
export const exchanged = (document: StudioDocument): StudioDocument => ({ ...document, first: document.second, second: document.first });
