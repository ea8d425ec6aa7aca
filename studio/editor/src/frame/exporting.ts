// SPDX-License-Identifier: Apache-2.0
// The curve as a file: samples, or what the player plays.
import { element, menu } from 'orispline-viewer/look/element';
import { sentence } from '../document/sentence';
import { notANumber, numberIn } from '../edits/reasons';
import type { Trouble } from '../engine/protocol';
import { samplesText } from '../file/exports';
import type { Studio } from '../store/studio';
import { ask } from './dialog';
import { download } from './download';
import type { Item } from './popup';

const mostSamples = 1e6;
const degree = Math.PI / 180;
const usual = { samples: '600', tolerance: '0.001' };
const orders: [string, string][] = [['0', 'none'], ['1', 'velocity'], ['2', 'velocity, acceleration'], ['3', 'velocity, acceleration, jerk']];

const stemOf = (name: string) => name.replace(/(\.[^.]*)?$/, '');

interface Question {
  title: string;
  label: string;
  value: string;
  more?: HTMLElement[];
  /** A sentence where the number cannot be. */
  refused: (value: number) => string | null;
}

/** A number that the user gives; null: the user does not want it. */
async function numberFrom(place: HTMLElement, { title, label, value, more = [], refused }: Question): Promise<number | null> {
  let [text, why] = [value, ''];
  for (;;) {
    const field = element('input', { value: text, inputMode: 'decimal', attributes: { 'aria-label': label } });
    const content = [element('label', { className: 'choice' }, element('span', {}, label), field), ...more, element('p', { className: 'trouble', attributes: { role: 'alert' } }, why)];
    if ((await ask(place, title, content, [{ label: 'Export', isFirst: true }, { label: 'Cancel' }])) !== 'Export') return null;
    text = field.value;
    const found = numberIn(text);
    why = notANumber(text) ?? refused(found!) ?? '';
    if (why === '') return found;
  }
}

async function exportSamples({ store, engine, original }: Studio, place: HTMLElement): Promise<string | null> {
  const [line, select] = menu('Rates', orders, () => {});
  select.value = '3';
  const refused = (count: number) => (Number.isInteger(count) && count >= 2 && count <= mostSamples ? null : `Found ${count} samples, wanted a whole number from 2 to ${mostSamples}. Give such a number.`);
  const count = await numberFrom(place, { title: 'Samples of the curve', label: 'Samples at even times', value: usual.samples, more: [line], refused });
  if (count === null) return null;
  const { keys, first: choice } = store.current().document;
  const samples = await engine.ask('sample', { keys, choice, count, rates: Number(select.value) as 0 | 1 | 2 | 3 });
  const name = `${stemOf(original.name)}_samples.csv`;
  download(name, samplesText(samples, original.epoch));
  return name;
}

async function exportBaked({ store, engine, original }: Studio, place: HTMLElement): Promise<string | null> {
  const refused = (tolerance: number) => (tolerance > 0 ? null : `Found a tolerance of ${tolerance}°, wanted more than 0. Give a larger one.`);
  const tolerance = await numberFrom(place, { title: 'The curve for orispline/player', label: 'Tolerance [°]', value: usual.tolerance, refused });
  if (tolerance === null) return null;
  const { keys, first: choice } = store.current().document;
  const name = `${stemOf(original.name)}.json`;
  download(name, await engine.ask('bake', { keys, choice, tolerance: tolerance * degree }));
  return name;
}

export function exportsOf(studio: Studio, place: () => HTMLElement, tell: (sentence: string) => void): Item[] {
  const attempt = async (work: typeof exportSamples) => {
    try {
      const name = await work(studio, place());
      if (name) tell(`${name} is in your downloads.`);
    } catch (trouble) {
      tell(`Nothing was exported: ${sentence((trouble as Trouble).message)}`);
    }
  };
  return [
    { label: 'Samples', note: 'CSV', chosen: () => void attempt(exportSamples) },
    { label: 'Curve for the player', note: 'JSON', chosen: () => void attempt(exportBaked) },
  ];
}
