// SPDX-License-Identifier: Apache-2.0
// The methods of both curves, and their settings.
import type { Choice, Setting, StudioDocument, Which } from '../document/document';

/** What a method knows, as the library tells it. */
export interface Known {
  readonly name: string;
  readonly parameters: readonly { readonly name: string; readonly min: number; readonly max: number }[];
  readonly choices: readonly { readonly name: string; readonly words: readonly string[] }[];
  readonly ends: readonly string[];
  readonly closes: boolean;
}

/** A rule for both ends, or one for each: `rest`, `natural,clamped`. */
export const endsOf = (text: string): string[] => text.split(',');

const rest = '0,0,0';
export const rateNames = ['start_rate', 'end_rate']; // of each end [rad/s], body

/** Whether the ends, first and last, have a rate that is given. */
export function clamped({ settings: { ends } }: Choice): [start: boolean, end: boolean] {
  const rules = typeof ends === 'string' ? endsOf(ends) : [];
  return [rules[0] === 'clamped', rules[rules.length - 1] === 'clamped'];
}

/** Closed by its last key, or after a period. */
export const isLoop = ({ settings }: Choice): boolean => settings.closed === true || settings.period !== undefined;

/** A loop has no ends, and an end has a rate exactly where it is clamped. */
function coherent(choice: Choice): Choice {
  const settings: Record<string, Setting> = { ...choice.settings };
  if (isLoop(choice)) delete settings.ends;
  clamped({ ...choice, settings }).forEach((isClamped, end) => {
    if (isClamped) settings[rateNames[end]] ??= rest;
    else delete settings[rateNames[end]];
  });
  return { ...choice, settings };
}

const isRate = (value: Setting): boolean => typeof value === 'string' && value.split(',').length === 3 && value.split(',').every((number) => number.trim() !== '' && Number.isFinite(Number(number)));

/** Whether a method has such a setting, and may have this value of it. */
export function knows(method: Known, name: string, value: Setting): boolean {
  if (name === 'closed') return method.closes && typeof value === 'boolean';
  if (name === 'ends') return typeof value === 'string' && endsOf(value).length <= 2 && endsOf(value).every((end) => method.ends.includes(end));
  if (name === 'period') return method.closes && typeof value === 'number' && value > 0;
  if (rateNames.includes(name)) return method.ends.includes('clamped') && isRate(value);
  const parameter = method.parameters.find((candidate) => candidate.name === name);
  if (parameter) return typeof value === 'number' && parameter.min <= value && value <= parameter.max;
  return typeof value === 'string' && (method.choices.find((candidate) => candidate.name === name)?.words.includes(value) ?? false);
}

/** Another method. Settings that it knows are kept; others are dropped. */
export function withMethod(document: StudioDocument, which: Which, method: Known): StudioDocument {
  const choice: Choice = document[which];
  if (choice.method === method.name) return document;
  const settings = Object.fromEntries(Object.entries(choice.settings).filter(([name, value]) => knows(method, name, value)));
  return { ...document, [which]: coherent({ method: method.name, settings }) };
}

/** One setting, or without a value the method's own again. One that the method refuses changes nothing, nor does one that keys have of their own. */
export function withSetting(document: StudioDocument, which: Which, method: Known, name: string, value?: Setting): StudioDocument {
  const choice: Choice = document[which];
  if (choice.method !== method.name || choice.settings[name] === value) return document;
  const { [name]: _, ...others } = choice.settings;
  if (value === undefined) return { ...document, [which]: coherent({ ...choice, settings: others }) };
  const isOwn = document.keys.some(({ own }) => name in own);
  return isOwn || !knows(method, name, value) ? document : { ...document, [which]: coherent({ ...choice, settings: { ...choice.settings, [name]: value } }) };
}

/** Both curves in each other's place. */
export const exchanged = (document: StudioDocument): StudioDocument => ({ ...document, first: document.second, second: document.first });
