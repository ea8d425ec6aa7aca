// SPDX-License-Identifier: Apache-2.0
// Methods with their settings, as texts and as what the library takes.
import type { Settings } from 'orispline/method';
import type { Choice, Key, Setting } from '../document/document';
import type { MethodInfo } from './protocol';

const settingOf = (text: string | undefined): Setting => (text === undefined ? true : text !== '' && Number.isFinite(Number(text)) ? Number(text) : text);

/** Of a text such as `timed-c2:tension=0.6:closed`. */
export function choiceOf(text: string): Choice {
  const [method, ...pieces] = text.split(':');
  const settings = pieces.map((piece) => piece.split('=')).map(([name, value]) => [name, settingOf(value)]);
  return { method, settings: Object.fromEntries(settings) };
}

/** The parameters that keys may have values of their own of. */
export const perKey = (methods: readonly MethodInfo[], method?: string): Set<string> =>
  new Set(methods.flatMap(({ name, parameters }) => (method && method !== name ? [] : parameters.filter(({ per_key }) => per_key).map((one) => one.name))));

/** Those of a choice on these keys, of which some may have their values. */
export function settingsOf({ method, settings }: Choice, keys: readonly Key[], methods: readonly MethodInfo[]): Settings {
  const names = perKey(methods, method), own = Object.keys(keys[0]?.own ?? {}).filter((name) => names.has(name));
  return { ...settings, ...Object.fromEntries(own.map((name) => [name, keys.map((key) => key.own[name])])) };
}
