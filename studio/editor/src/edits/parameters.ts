// SPDX-License-Identifier: Apache-2.0
// Numbers of the methods, such as tensions: one for all keys, which is a setting of a choice, or one at each key, which rules for both curves.
// A value beyond what a parameter may have becomes the nearest one that it may have; one that is no number changes nothing.
import type { Choice, Key, StudioDocument, Which } from '../document/document';
import { withKey } from '../document/keys';

export interface Parameter {
  readonly name: string;
  readonly default: number;
  readonly min: number;
  readonly max: number;
}

const allowed = ({ min, max }: Parameter, value: number): number => Math.min(Math.max(value, min), max);

export const hasOwn = ({ keys }: StudioDocument, name: string): boolean => keys.length > 0 && name in keys[0].own;

function without<Value>(members: Readonly<Record<string, Value>>, name: string): Readonly<Record<string, Value>> {
  if (!(name in members)) return members;
  const { [name]: _, ...others } = members;
  return others;
}

const unset = (choice: Choice, name: string): Choice => (name in choice.settings ? { ...choice, settings: without(choice.settings, name) } : choice);

/** What all keys have that have no value of their own: the setting of a choice, else what the method says. */
export function valueForAll(document: StudioDocument, which: Which, parameter: Parameter): number {
  const setting = document[which].settings[parameter.name];
  return typeof setting === 'number' ? setting : parameter.default;
}

/** The value at a key, whether it is its own or that of all keys. */
export const valueAt = (document: StudioDocument, key: Key, which: Which, parameter: Parameter): number =>
  key.own[parameter.name] ?? valueForAll(document, which, parameter);

const withColumn = (document: StudioDocument, name: string, value: number): StudioDocument => ({
  ...document,
  keys: document.keys.map((key) => ({ ...key, own: { ...key.own, [name]: value } })),
  first: unset(document.first, name),
  second: unset(document.second, name),
});

/** A key's own value. Where keys have none of their own yet, all others get what all have had with that choice. */
export function withOwn(document: StudioDocument, id: number, which: Which, parameter: Parameter, value: number): StudioDocument {
  const { name } = parameter;
  if (Number.isNaN(value) || !document.keys.some((key) => key.id === id)) return document;
  const prepared = hasOwn(document, name) ? document : withColumn(document, name, valueForAll(document, which, parameter));
  const own = allowed(parameter, value);
  return withKey(prepared, id, (key) => (key.own[name] === own ? key : { ...key, own: { ...key.own, [name]: own } }));
}

/** The same value for all keys: at each of them where they have their own, else as a setting of the choice. */
export function withValueForAll(document: StudioDocument, which: Which, parameter: Parameter, value: number): StudioDocument {
  const { name } = parameter;
  if (Number.isNaN(value)) return document;
  const all = allowed(parameter, value);
  if (hasOwn(document, name)) return document.keys.every(({ own }) => own[name] === all) ? document : withColumn(document, name, all);
  const choice = document[which];
  return choice.settings[name] === all ? document : { ...document, [which]: { ...choice, settings: { ...choice.settings, [name]: all } } };
}

/** Keys without values of their own; what all of them have is then a setting again, or the default of the method. */
export const withoutOwn = (document: StudioDocument, name: string): StudioDocument =>
  hasOwn(document, name) ? { ...document, keys: document.keys.map((key) => ({ ...key, own: without(key.own, name) })) } : document;
