// SPDX-License-Identifier: Apache-2.0
// What one may begin with.
import camera from '../../../../examples/data/camera_keys.csv?raw';
import five from '../../../../examples/data/five_keys.csv?raw';
import flight from '../../../../examples/data/flight_keys.csv?raw';

/** What is up in the world of the keys, what the body is, and which of its axes is looked at. */
export interface Looks {
  readonly up: 'y' | 'z';
  readonly body: 'box' | 'camera' | 'aircraft';
  readonly axis: 'x' | 'z'; // whose way over the sphere is shown
}

export interface Template {
  readonly title: string;
  readonly sentence: string;
  readonly name: string; // of the file
  readonly text: string;
  readonly first: string; // methods of both curves
  readonly second: string;
  readonly looks?: Looks;
}

const paperTensions = [0.1, 0.6, 0, 0.6, 0.1]; // of figure 3 of Tan et al. 2018

/** The rows of a file, each made anew, below a comment of their own and its units. */
function remade(text: string, comment: string, column: string, row: (row: string, index: number) => string): string {
  const lines = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const units = text.split('\n').filter((line) => line.startsWith('# Units'));
  const [header, ...rows] = lines;
  return `${[`# ${comment}`, ...units, header + column, ...rows.map(row)].join('\n')}\n`;
}

const evenly = (row: string, i: number) => `${i}${row.slice(row.indexOf(','))}`;

/** The paper's own orientations are not published. */
const withPaperTensions = remade(five, 'Five keyframes at the times and with the tensions of figure 3 of Tan et al. 2018, for the method quintic.', ',tension', (row, i) => `${evenly(row, i)},${paperTensions[i]}`);

/** What the page opens with. */
export const motion: Template = {
  title: 'An aircraft',
  sentence: 'An aircraft at five orientations, a second apart.',
  name: 'aircraft_keys.csv',
  text: remade(five, 'Five keyframes of an aircraft, a second apart.', '', evenly),
  first: 'auto',
  second: 'slerp',
  looks: { up: 'z', body: 'aircraft', axis: 'x' },
};

export const templates: readonly Template[] = [
  {
    title: 'Five keys',
    sentence: 'Five orientations, a second apart.',
    name: 'five_keys.csv',
    text: remade(five, 'Five keyframes, a second apart.', '', evenly),
    first: 'auto',
    second: 'slerp',
  },
  {
    title: 'A camera',
    sentence: 'A camera that circles a subject, at 25 frames per second.',
    name: 'camera_keys.csv',
    text: camera,
    first: 'auto',
    second: 'slerp',
    looks: { up: 'y', body: 'camera', axis: 'z' }, // it looks along -z
  },
  {
    title: 'The flight',
    sentence: 'An aerobatic flight of 48 s: a turn, a loop, a roll and a climbing turn.',
    name: 'flight_keys.csv',
    text: flight,
    first: 'auto',
    second: 'squad',
    looks: { up: 'z', body: 'aircraft', axis: 'x' },
  },
  {
    title: 'Tensions of a paper',
    sentence: 'Five keys with a tension each, for quintic, which is made for even times.',
    name: 'five_tensions.csv',
    text: withPaperTensions,
    first: 'quintic',
    second: 'slerp',
  },
];
