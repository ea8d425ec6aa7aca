// SPDX-License-Identifier: Apache-2.0
// Orientations in the forms of files. The library makes the numbers and says what it reads out of them; of the numbers near to these, those are
// taken that are read as the very orientation, else short ones that are read as one that is as near.
import type { Quaternion } from '../document/document';
import { fullTurn, type Form } from '../document/form';
import { alignment } from '../document/keys';
import type { Library } from './library';
import { used } from './library';
import type { Given, Told } from './protocol';

const steps = [0, 1, -1, 2, -2]; // units in the last place
const digits = [6, 7, 8, 9, 10, 11, 12, 13]; // that short numbers have behind the point
const near = 2 * Number.EPSILON; // of a component of a quaternion

type Numbers = readonly number[];

const writing = (form: Form): Record<string, string> =>
  form.kind === 'euler' ? { output_orientation: 'euler', output_euler: form.order, output_angle_unit: form.unit } : { output_orientation: form.kind };

const namesOf = (form: Form): string[] =>
  form.kind === 'euler' ? ['e1', 'e2', 'e3'].map((name) => `${name}_${form.unit}`)
  : form.kind === 'rotvec' ? ['rx', 'ry', 'rz'].map((name) => `${name}_${form.unit}`)
  : [...'123'].flatMap((row) => [...'123'].map((column) => `r${row}${column}`));

function stepped(value: number, step: number): number {
  if (step === 0 || value === 0) return value;
  const number = Float64Array.of(value), bits = new BigInt64Array(number.buffer);
  bits[0] += BigInt(step);
  return number[0];
}

const distance = (some: Numbers, others: Numbers): number => Math.max(...some.map((number, i) => Math.abs(number - others[i])));

/** Of numbers that state one orientation, those that are nearest to what stands there now. */
function likest(numbers: Numbers, form: Form, beside: Numbers | null): Numbers {
  if (form.kind === 'matrix' || !beside) return numbers;
  const turn = fullTurn[form.unit];
  if (form.kind === 'rotvec') {
    const length = Math.hypot(...numbers);
    const ways = length > 0 ? [numbers, numbers.map((number) => number * (1 - turn / length))] : [numbers];
    return ways.reduce((best, way) => (distance(way, beside) < distance(best, beside) ? way : best));
  }
  const [first, second, third] = numbers, isProper = form.order.at(0) === form.order.at(2);
  const other = [first + turn / 2, isProper ? -second : turn / 2 - second, third + turn / 2];
  const ways = [numbers, other].map((way) => way.map((angle, i) => angle + turn * Math.round((beside[i] - angle) / turn)));
  return ways.reduce((best, way) => (distance(way, beside) < distance(best, beside) ? way : best));
}

/** The numbers themselves, their neighbours, and short ones. */
function candidatesOf(numbers: Numbers): Numbers[] {
  const short = digits.map((count) => numbers.map((number) => Number(number.toFixed(count))));
  if (numbers.length > 3) return [numbers, ...short];
  const [a, b, c] = numbers;
  return [...short, ...steps.flatMap((i) => steps.flatMap((j) => steps.map((k) => [stepped(a, i), stepped(b, j), stepped(c, k)])))];
}

const textOf = (number: number): string => (Object.is(number, -0) ? '0' : String(number));

export class Forms {
  private readonly library: Library;

  constructor(library: Library) {
    this.library = library;
  }

  stated({ orientations, form, beside }: Given<'stated'>): Told<'stated'> {
    const numbers = this.written(orientations, form);
    const candidates = numbers.map((row, i) => candidatesOf(likest(row, form, beside[i])));
    const read = this.read(candidates.flat(), form);
    let from = 0;
    return orientations.map((q, i) => {
      const rows = candidates[i], found = read.slice(from, (from += rows.length));
      return this.best(q, rows, found);
    });
  }

  private best(q: Quaternion, rows: readonly Numbers[], found: readonly Quaternion[]): Told<'stated'>[number] {
    const all = rows.map((row, k) => {
      const sign = alignment(q, found[k]) < 0 ? -1 : 1;
      return { row, off: distance(found[k].map((number) => sign * number), q) };
    });
    const chosen = all.find(({ off }) => off === 0) ?? all.find(({ off }) => off <= near) ?? all.reduce((best, one) => (one.off < best.off ? one : best));
    return { texts: chosen.row.map(textOf), off: chosen.off };
  }

  private written(orientations: readonly Quaternion[], form: Form): Numbers[] {
    const times = Float64Array.from(orientations, (_, k) => k);
    const { bytes } = this.library.write({ times, orientations: Float64Array.from(orientations.flat()), order: 'wxyz' }, 'keys.csv', writing(form));
    const lines = new TextDecoder().decode(bytes).split('\n').filter((line) => /^[-\d]/.test(line));
    const scale = form.kind === 'rotvec' ? fullTurn[form.unit] / fullTurn.rad : 1;
    const rows = lines.map((line) => line.split(',').slice(1).map((cell) => Number(cell) * scale));
    // The order ZYX has its angles by the names of the axes: roll, pitch, yaw.
    return form.kind === 'euler' && form.order === 'ZYX' ? rows.map((row) => row.toReversed()) : rows;
  }

  private read(rows: readonly Numbers[], form: Form): Quaternion[] {
    const text = [['t', ...namesOf(form)].join(), ...rows.map((row, k) => [k, ...row].join()), ''].join('\n');
    return used(this.library.read(text, 'keys.csv', form.kind === 'euler' ? { euler: form.order } : {}), (track) => {
      const q = track.column('orientations', 'wxyz');
      return rows.map((_, k) => [q[4 * k], q[4 * k + 1], q[4 * k + 2], q[4 * k + 3]] as const);
    });
  }
}
