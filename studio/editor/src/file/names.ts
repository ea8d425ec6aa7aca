// SPDX-License-Identifier: Apache-2.0
// The names of columns, compared as the library compares them.
import type { Cell } from './table';

export interface Header {
  readonly names: readonly string[]; // as they are written
  readonly compared: readonly string[];
  readonly stated: Readonly<Record<string, string>>; // the columns that whoever reads the file names, by what they are for
}

/** A unit in brackets as the end of the name: `px [mm]` is `px_mm`. */
function plain(name: string): string {
  const found = /^(.+?) *[([]([^([\])]*)[)\]]$/.exec(name);
  if (!found || /^\d+$/.test(found[2])) return name;
  const unit = found[2].replace(/[µμ]/g, 'u').replace(/°/g, 'deg').replace(/²/g, '2').replace(/³/g, '3').replaceAll('/', '_').replace(/[\^ ]/g, '');
  return unit ? `${found[1]}_${unit}` : found[1];
}

/** Names are compared without case and blanks; those of ROS and PX4 are ours. */
function compared(name: string): string {
  const text = plain(name).replace(/[ \t]/g, '').toLowerCase().replace(/[./]/g, '_');
  const part = text.replace(/^(_|pose_)+/, '');
  const theirs = /^(?:(orientation|q)_([wxyz])|(position)_([xyz])|q\[([0-3])\])(?=_|$)(.*)$/.exec(part);
  if (!theirs) return text;
  const [, orientation, component, position, axis, index, rest] = theirs;
  return (orientation ? `q${component}` : position ? `p${axis}` : `q${'wxyz'[Number(index)]}`) + rest;
}

/** `stated`: as the option `columns` has it, such as `t=moment,qw=w`. */
export function headerOf(cells: readonly Cell[], stated = ''): Header {
  const names = cells.map(({ content }) => content);
  return { names, compared: names.map(compared), stated: Object.fromEntries(stated.split(',').filter(Boolean).map((pair) => pair.split('=', 2))) };
}

/** The column of a name: as it is written, else alike; -1 where there is none, or several. */
export function columnNamed({ names, compared: others, stated }: Header, name: string): number {
  const wanted = stated[name] ?? name;
  if (names.includes(wanted)) return names.indexOf(wanted);
  const alike = compared(wanted);
  return others.indexOf(alike) === others.lastIndexOf(alike) ? others.indexOf(alike) : -1;
}

/** The end of a name that says a unit, such as `_deg` of `Yaw [deg]`; for what `columns` names that of the column counts. */
export const unitOf = (header: Header, index: number): string => /_([a-z0-9]+)$/.exec(header.compared[index])?.[1] ?? '';

/** Of a quantity by its own name, or by that with one of the units behind it; -1 where there is none. */
export function columnWithUnit(header: Header, name: string, units: readonly string[]): number {
  for (const unit of ['', ...units.map((one) => `_${one}`)]) {
    const index = columnNamed(header, name + unit);
    if (index >= 0) return index;
  }
  return -1;
}
