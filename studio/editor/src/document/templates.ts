// SPDX-License-Identifier: Apache-2.0
// What one may begin with.
import camera from '../../../../examples/data/camera_keys.csv?raw';
import five from '../../../../examples/data/five_keys.csv?raw';
import flight from '../../../../examples/data/flight_keys.csv?raw';

/** What is up in the world of the keys, what the body is, and which of its axes is looked at. */
export interface Looks {
  readonly up: 'y' | 'z';
  readonly body: 'box' | 'camera';
  readonly axis: 'x' | 'z'; // whose way over the sphere is shown
}

export interface Template {
  readonly title: string;
  readonly sentence: string;
  readonly name: string; // of the file
  readonly text: string;
  readonly first: string; // methods of A and B
  readonly second: string;
  readonly looks?: Looks;
}

const paperTensions = [0.1, 0.6, 0, 0.6, 0.1]; // of figure 3 of Tan et al. 2018

/** The five keys at the even times of the paper, with its tensions; its own orientations are not published. */
function withPaperTensions(text: string): string {
  const lines = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const comments = text.split('\n').filter((line) => line.startsWith('# Units'));
  const [header, ...rows] = lines;
  const timed = rows.map((row, i) => `${i}${row.slice(row.indexOf(','))},${paperTensions[i]}`);
  const source = '# Five keyframes at the times and with the tensions of figure 3 of Tan et al. 2018, for the method quintic.';
  return `${[source, ...comments, `${header},tension`, ...timed].join('\n')}\n`;
}

export const templates: readonly Template[] = [
  {
    title: 'Five keys',
    sentence: 'Five orientations with the tensions of a paper, one at each key.',
    name: 'five_keys.csv',
    text: withPaperTensions(five),
    first: 'quintic',
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
  },
];
