// SPDX-License-Identifier: Apache-2.0
// Dates of ISO 8601 as docs/files.md has them, as exact seconds since 1970-01-01T00:00:00Z, in which every day has 86400 s; and back, as they were written.
import { type Decimal, decimalOf, decimalText, difference, numberOf, sum } from '../document/decimal';

/** How a date is written. */
export interface DateStyle {
  readonly isOrdinal: boolean; // the day of the year in the place of month and day
  readonly separator: string; // before the time of day; '' where there is none
  readonly hasSeconds: boolean;
  readonly zone: string; // `Z`, `+02:00`, …
  readonly ahead: number; // of UTC [min]
}

const form = /^(\d{4})-(?:(\d{2})-(\d{2})|(\d{3}))(?:([Tt ])(\d{2}):(\d{2})(?::(\d{2}(?:\.\d+)?))?([Zz]|[+-]\d{2}(?::?\d{2})?)?)?$/;
const dayLength = 86400; // [s]

const dayOf = (year: number, month: number, day: number): number => new Date(0).setUTCFullYear(year, month - 1, day) / (1000 * dayLength);

const whole = (number: number): Decimal => decimalOf(String(number))!;

function minutesOf(zone: string): number {
  const [, sign, hours, minutes] = /^([+-])(\d{2}):?(\d{2})?$/.exec(zone) ?? [];
  return hours ? Number(`${sign}1`) * (60 * Number(hours) + Number(minutes ?? 0)) : 0;
}

/** Null: it is no date. */
export function dateIn(text: string): { seconds: Decimal; style: DateStyle } | null {
  const found = form.exec(text);
  if (!found) return null;
  const [, year, month, day, dayOfYear, separator = '', hour = '0', minute = '0', second, zone = ''] = found;
  const days = dayOfYear ? dayOf(Number(year), 1, 1) + Number(dayOfYear) - 1 : dayOf(Number(year), Number(month), Number(day));
  const ahead = minutesOf(zone);
  const minutes = (24 * days + Number(hour)) * 60 + Number(minute) - ahead;
  return { seconds: sum(whole(60 * minutes), decimalOf(second ?? '0')!), style: { isOrdinal: dayOfYear !== undefined, separator, hasSeconds: second !== undefined, zone, ahead } };
}

const padded = (number: number, digits = 2): string => String(number).padStart(digits, '0');

/** In a style, with as many decimals as there are, and with the time of day where it is not midnight; null beyond four digits of a year. */
export function dateText(seconds: Decimal, { isOrdinal, separator, hasSeconds, zone, ahead }: DateStyle): string | null {
  const local = sum(seconds, whole(60 * ahead)), minutes = Math.floor(numberOf(local) / 60);
  let left = difference(local, whole(60 * minutes)), minute = minutes;
  if (left.digits < 0n) [left, minute] = [sum(left, whole(60)), minute - 1]; // the double was rounded up to a full minute
  const day = Math.floor(minute / 1440), inDay = minute - 1440 * day, at = new Date(1000 * dayLength * day), year = at.getUTCFullYear();
  if (!(year >= 0 && year <= 9999)) return null;
  const date = isOrdinal ? padded(day - dayOf(year, 1, 1) + 1, 3) : `${padded(at.getUTCMonth() + 1)}-${padded(at.getUTCDate())}`;
  const exact = decimalText(left);
  const hasTime = separator !== '' || inDay !== 0 || exact !== '0';
  const second = hasSeconds || exact !== '0' ? `:${exact.replace(/^\d(?=\.|$)/, '0$&')}` : '';
  return `${padded(year, 4)}-${date}${hasTime ? `${separator || 'T'}${padded(Math.floor(inDay / 60))}:${padded(inDay % 60)}${second}${zone}` : ''}`;
}
