// SPDX-License-Identifier: Apache-2.0
// Samples as the text of a file, in the columns and the form of numbers of `orispline sample`.
import { decimalOf, decimalText, shortest, sum } from '../document/decimal';
import type { Samples } from '../engine/protocol';

type Rows = Omit<Samples, 'orders'>;

/** The shortest text that reads back as the same double, in the library's form: `1e-05`, `12`. */
export function libraryText(value: number): string {
  const [mantissa, power] = value.toExponential().split('e');
  const exponent = Number(power);
  if (value === 0) return Object.is(value, -0) ? '-0' : '0';
  if (exponent < -4 || exponent >= 16) return `${mantissa}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
  return decimalText(shortest(value));
}

/** One line a sample; the times are those of the file, whose times count from `epoch`. Columns that are empty are left out. */
export function samplesText(samples: Rows, epoch: string): string {
  const columns = [
    { names: 'qw,qx,qy,qz', numbers: samples.q },
    { names: 'px,py,pz', numbers: samples.p },
    { names: 'wx,wy,wz', numbers: samples.w },
    { names: 'ax,ay,az', numbers: samples.a },
    { names: 'jx,jy,jz', numbers: samples.j },
  ].filter(({ numbers }) => numbers.length > 0);
  const zero = decimalOf(epoch)!;
  const lines = Array.from(samples.t, (t, i) => {
    const cells = columns.flatMap(({ names, numbers }) => {
      const width = names.split(',').length;
      return Array.from(numbers.subarray(width * i, width * (i + 1)), libraryText);
    });
    return [decimalText(sum(zero, shortest(t))), ...cells].join();
  });
  return `${['t', ...columns.map(({ names }) => names)].join()}\n${lines.join('\n')}\n`;
}
