// SPDX-License-Identifier: Apache-2.0
// Of a recording the keys that it needs: how near they are to be, how far the work is, and what the user takes of what was found.
import { element } from 'orispline-viewer/look/element';
import { sentence } from '../document/sentence';
import { mostKeys, stopped, type Engine, type Given as Asked, type Opened, type Reduced, type TooMany, type Trouble } from '../engine/protocol';
import { ask, sentences, whileWaiting } from './dialog';

type Wanted = Asked<'reduce'>;

const usualTolerance = '0.1deg';
const cornered = 'slerp'; // a method whose rates jump at each key: nobody who edits a motion is given it unasked
const smoothOnes = 'auto,timed-c2';
const seenNoise = 0.1; // share of the tolerance from which on noise is named

const degrees = (angle: number): string => `${Number(angle.toPrecision(2))}°`;
const keysOf = ({ count, method }: Pick<Reduced, 'count' | 'method'>): string => `${count} keys of ${method}`;

/** What was chosen and why, for a notice. */
function chosenBecause({ count, method, others, furthest, furthestPosition, smoothed }: Reduced, { positionTolerance }: Wanted): string {
  const fewest = others.length > 0 && others.every((other) => other.count >= count) ? ', which needs the fewest' : '';
  const than = others.length > 0 ? ` (${others.map((other) => `${other.method} ${other.count}`).join(', ')})` : '';
  const from = smoothed ? `the smoothed recording at most, ${degrees(smoothed.rms)} from its samples as they were (root mean square)` : 'the recording at most';
  const places = furthestPosition !== null && !positionTolerance ? ` Its positions, which had no tolerance, are up to ${Number(furthestPosition.toPrecision(2))} m from those of the recording.` : '';
  return `These are ${keysOf({ count, method })}${fewest}${than}. The curve is ${degrees(furthest)} from ${from}.${places}`;
}

const withNotice = (found: Reduced, wanted: Wanted): Opened | null =>
  found.opened && { ...found.opened, warnings: [...found.opened.warnings, { message: chosenBecause(found, wanted) }] };

const isGood = ({ method, opened }: Reduced): boolean => opened !== null && method !== cornered;

export class Reducing {
  constructor(
    private readonly engine: Engine,
    private readonly place: HTMLElement,
    private readonly source: Pick<Wanted, 'bytes' | 'name' | 'reading' | 'hash'>,
    private readonly recording: TooMany,
  ) {}

  /** Null where the user did not want it. */
  async opened(): Promise<Opened | null> {
    let [tolerance, positionTolerance, why] = [usualTolerance, '', ''];
    for (;;) {
      const stated = await this.tolerances(tolerance, positionTolerance, why);
      if (!stated) return null;
      [tolerance, positionTolerance] = [stated.tolerance, stated.positionTolerance ?? ''];
      try {
        return await this.chosen(stated);
      } catch (trouble) {
        if (trouble === stopped) why = '';
        else why = sentence((trouble as Trouble).message);
      }
    }
  }

  private async tolerances(tolerance: string, positionTolerance: string, why: string): Promise<Wanted | null> {
    const { name } = this.source, { count, hasPositions } = this.recording;
    const input = (value: string, label: string, placeholder = '') => element('input', { value, placeholder, spellcheck: false, attributes: { 'aria-label': label } });
    const angle = input(tolerance, 'Tolerance'), length = input(positionTolerance, 'Tolerance of positions', 'none, or such as 5mm');
    const field = (label: string, one: HTMLElement) => element('label', { className: 'choice' }, element('span', {}, label), one);
    const content = [
      element('p', {}, `${name} has ${count} keys; up to ${mostKeys} can be edited. Those that are needed can be found, so that the curve through them is nowhere farther from the recording than the tolerance.`),
      field('Tolerance', angle),
      ...(hasPositions ? [field('Tolerance of positions', length)] : []),
      element('p', { className: 'trouble', attributes: { role: 'alert' } }, why),
    ];
    const answer = await ask(this.place, 'Too many keys to edit', content, [{ label: 'Reduce to keys', isFirst: true }, { label: 'Cancel' }]);
    return answer === 'Reduce to keys' ? { ...this.source, tolerance: angle.value, positionTolerance: length.value.trim() || undefined } : null;
  }

  /** What the user takes. Throws `stopped` where the work was stopped. */
  private async chosen(wanted: Wanted): Promise<Opened | null> {
    const found = await this.found(wanted, 'Looking for the keys that are needed');
    if (isGood(found)) return withNotice(found, wanted);
    const smoothing: Wanted = { ...wanted, smooth: true };
    let smoothed = await this.found(smoothing, 'Looking at the noise');
    if (smoothed.method === cornered) smoothed = await this.found({ ...smoothing, methods: smoothOnes }, 'Looking for keys of a smooth curve');
    return this.ofBoth(found, smoothed, wanted, smoothing);
  }

  private async ofBoth(found: Reduced, smoothed: Reduced, wanted: Wanted, smoothing: Wanted): Promise<Opened | null> {
    const { name } = this.source, noise = smoothed.smoothed?.noise ?? 0;
    const unsmoothed = found.method === cornered ? `, at each of which the rates jump` : '';
    const rms = smoothed.smoothed ? `, ${degrees(smoothed.smoothed.rms)} from the samples as they were (root mean square)` : '';
    const content = sentences(
      noise > seenNoise * parseFloat(wanted.tolerance) * (/deg/.test(wanted.tolerance) ? 1 : 180 / Math.PI)
        ? `${name} has noise of about ${degrees(noise)} on each axis (standard deviation), which keys within ${wanted.tolerance} follow: it needs ${keysOf(found)}${unsmoothed}.`
        : `${name} needs ${keysOf(found)} within ${wanted.tolerance}${unsmoothed}.`,
      `Smoothed first, it needs ${keysOf(smoothed)} within ${wanted.tolerance} of the smoothed recording${rms}.`,
      ...(smoothed.opened || found.opened ? [] : [`Both are more than the ${mostKeys} that can be edited: state a larger tolerance.`]),
    );
    const smoother = found.others.filter(({ method, count }) => method !== cornered && count <= mostKeys).toSorted((one, next) => one.count - next.count).at(0);
    const taking: [label: string, take: () => Promise<Opened | null>][] = [
      ...(smoothed.opened ? [['Smooth first', async () => withNotice(smoothed, smoothing)] as (typeof taking)[number]] : []),
      ...(smoother ? [[`Take the ${keysOf(smoother)}`, () => this.only(wanted, smoother.method)] as (typeof taking)[number]] : []),
      ...(found.opened ? [[`Take the ${keysOf(found)}`, async () => withNotice(found, wanted)] as (typeof taking)[number]] : []),
    ];
    const other = 'Another tolerance', labels = [...taking.map(([label]) => label), other, 'Cancel'];
    const answer = await ask(this.place, 'Smooth the recording first?', content, labels.map((label, i) => ({ label, isFirst: i === 0 })));
    if (answer === other) throw stopped;
    return (await taking.find(([label]) => label === answer)?.[1]()) ?? null;
  }

  /** Keys of a method that does not need the fewest. */
  private async only(wanted: Wanted, method: string): Promise<Opened | null> {
    const one: Wanted = { ...wanted, methods: method };
    return withNotice(await this.found(one, 'Looking for keys of a smooth curve'), one);
  }

  private found(wanted: Wanted, what: string): Promise<Reduced> {
    return whileWaiting(this.place, what, (progress) => this.engine.ask('reduce', wanted, progress), () => this.engine.stop());
  }
}
