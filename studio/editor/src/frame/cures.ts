// SPDX-License-Identifier: Apache-2.0
// What a user may say of a file that cannot be read as it is, or that may be meant otherwise: each is a button, and opens the file anew.
import { element } from 'orispline-viewer/look/element';
import { hasCommas, plainReading, type Reading } from '../document/reading';
import { sha256 } from '../engine/hash';
import type { Trouble } from '../engine/protocol';
import { namesIn } from '../file/columns';
import { repaired } from '../file/repair';
import { ask, sentences } from './dialog';
import type { Action } from './notices';
import type { Given } from './opening';

/** The file as the user has said that it is meant; null where he has not. */
type Change = (given: Given, place: HTMLElement) => Given | null | Promise<Given | null>;
type Cure = [label: string, change: Change];

const textOf = ({ bytes }: Given): string => new TextDecoder().decode(bytes);

const read = (given: Given, more: Partial<Reading>): Given => {
  const { options, comma } = given.reading ?? plainReading;
  return { ...given, reading: { options: { ...options, ...more.options }, comma: more.comma ?? comma } };
};

const stating = (options: Reading['options']): Change => (given) => read(given, { options });

/** Mended in its text, else by the library, so that the rows cannot stay when it is saved. */
const mending = (remedy: string, option = remedy): Change => (given) => {
  const text = repaired(textOf(given), remedy, given.reading ?? plainReading);
  return text === null ? read(given, { options: { [option]: true } }) : { ...given, bytes: new TextEncoder().encode(text), hash: given.hash ?? sha256(given.bytes) };
};

const field = (label: string, input: HTMLElement) => element('label', { className: 'choice' }, element('span', {}, label), input);

/** Asks for one text. */
const asking = (title: string, said: string, label: string, value: string, option: string): Change => async (given, place) => {
  const input = element('input', { value, spellcheck: false, attributes: { 'aria-label': label } });
  const answer = await ask(place, title, [...sentences(said), field(label, input)], [{ label: 'Read it so', isFirst: true }, { label: 'Cancel' }]);
  return answer === 'Read it so' ? read(given, { options: { [option]: input.value.trim() } }) : null;
};

const choice = (label: string, values: readonly string[], chosen: string): HTMLSelectElement =>
  element('select', { attributes: { 'aria-label': label } }, ...values.map((value) => element('option', { value, selected: value === chosen }, value || '–')));

const ofThree = ['ZYX', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'XYX', 'XZX', 'YXY', 'YZY', 'ZXZ', 'ZYZ'];

const order: Change = async (given, place) => {
  const select = choice('Order', [...ofThree, ...ofThree.map((one) => one.toLowerCase())], 'ZYX');
  const said = 'The angles are three turns: in which order, and about which axes? Capitals are turns about the axes of the body, each where the turns before have left it; small letters are turns about the axes of the world.';
  const answer = await ask(place, 'Order of the angles', [...sentences(said), field('Order', select)], [{ label: 'Read it so', isFirst: true }, { label: 'Cancel' }]);
  return answer === 'Read it so' ? read(given, { options: { euler: select.value } }) : null;
};

const wanted: readonly [title: string, names: readonly string[]][] = [['Time', ['t']], ['Quaternion', ['qw', 'qx', 'qy', 'qz']], ['or angles', ['roll', 'pitch', 'yaw']], ['or rotation vector', ['rx', 'ry', 'rz']]];

const columns: Change = async (given, place) => {
  const names = namesIn(textOf(given));
  const alike = (name: string) => names.find((one) => one.toLowerCase().replace(/[^a-z]/g, '') === name) ?? '';
  const menus = wanted.flatMap(([, ours]) => ours).map((name) => [name, choice(name, ['', ...names], alike(name))] as const);
  const groups = wanted.map(([title, ours]) => element('fieldset', {}, element('legend', {}, title), ...menus.filter(([name]) => ours.includes(name)).map(([name, menu]) => field(name, menu))));
  const answer = await ask(place, 'Which column is which', [...sentences('Choose the column of the time, and those of one form of the orientation.'), ...groups], [{ label: 'Read it so', isFirst: true }, { label: 'Cancel' }]);
  const stated = menus.filter(([, { value }]) => value !== '').map(([name, { value }]) => `${name}=${value}`);
  return answer === 'Read it so' && stated.length > 0 ? read(given, { options: { columns: stated.join() } }) : null;
};

/** By the options of the library that mend a file. */
const cures: Readonly<Record<string, readonly Cure[]>> = {
  fps: [...['24', '25', '30', '60'].map((fps): Cure => [`${fps} frames/s`, stating({ fps })]), ['Other rate…', asking('Frame rate', 'How many frames has a second? A fraction such as 30000/1001 is exact.', 'Frames per second', '30000/1001', 'fps')]],
  angle_unit: [['Degrees', stating({ angle_unit: 'deg' })], ['Radians', stating({ angle_unit: 'rad' })]],
  euler: [['ZYX', stating({ euler: 'ZYX' })], ['XYZ', stating({ euler: 'XYZ' })], ['Other order…', order]],
  order: [['t, qw, qx, qy, qz', stating({ order: 'wxyz' })], ['t, qx, qy, qz, qw', stating({ order: 'xyzw' })]],
  columns: [['Say which column is which…', columns]],
  input_orientation: [['Angles', stating({ input_orientation: 'euler' })], ['Rotation vector', stating({ input_orientation: 'rotvec' })], ['Matrix', stating({ input_orientation: 'matrix' })]],
  normalise: [['Scale them to 1', stating({ normalise: true })]],
  time_scale: [['They are seconds', stating({ time_scale: '1' })], ['Milliseconds', stating({ time_scale: '1e-3' })], ['Microseconds', stating({ time_scale: '1e-6' })]],
  sort: [['Put the rows in order', mending('sort')]],
  drop_duplicates: [['Take out the later of the two rows', mending('drop_duplicates')]],
  jumps: [['Take out the later of the two rows', mending('jumps', 'drop_duplicates')]],
  drop_invalid: [['Leave out the rows without numbers', mending('drop_invalid')]],
  ignore_recipe: [['Take out that comment', mending('recipe', 'ignore_recipe')]],
  session: [['Take the first recording', stating({ session: '1' })], ['Take the second', stating({ session: '2' })]],
};

const comma: Cure = ['Read commas as decimal points', (given) => read(given, { comma: true })];

/** Buttons that open a file as it is meant. `open`: what is done with it then. */
export function curesOf({ remedy }: Pick<Trouble, 'remedy'>, given: Given, place: () => HTMLElement, open: (given: Given) => void, isRefused = true): Action[] {
  const commas = isRefused && !given.reading?.comma && hasCommas(textOf(given)) ? [comma] : [];
  const found = [...commas, ...(cures[remedy ?? ''] ?? [])];
  return found.map(([label, change]) => ({
    label,
    chosen: async () => {
      const changed = await change(given, place());
      if (changed) open(changed);
    },
  }));
}
