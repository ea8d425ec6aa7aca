// SPDX-License-Identifier: Apache-2.0
// What the worker does with files, in a test: by the npm package where ORISPLINE_NPM is the folder of it, else by a small reader of simple
// tables that knows nothing of the studio's.
import { pathToFileURL } from 'node:url';
import { isDeepStrictEqual } from 'node:util';

const parameters = ['tension', 'tension2', 'bias', 'continuity'];
const triples = (numbers) => Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.slice(3 * i, 3 * i + 3)]);

/** Commas, or blanks; a header, or TUM; times in s or ms. */
function simpleRead(text) {
  const lines = text.replace(/^\uFEFF/, '').split(/\r?\n/).filter((line) => line.trim() !== '' && !line.trim().startsWith('#'));
  const cells = lines.map((line) => (line.includes(',') ? line.split(',') : line.trim().split(/\s+/)).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1')));
  const isTum = /^[-+.\d]/.test(cells[0][0]);
  const names = isTum ? ['t', 'px', 'py', 'pz', 'qx', 'qy', 'qz', 'qw'] : cells.shift();
  const time = names.findIndex((name) => /^t(_ms)?$/.test(name));
  const nanoseconds = (cell) => {
    const [whole, fraction = ''] = cell.split('.');
    const size = BigInt(whole.replace(/^-$/, '-0') + fraction.padEnd(24, '0')) * (names[time] === 't_ms' ? 1n : 1000n);
    return whole.startsWith('-') && whole.replace(/[-0]/g, '') === '' && size > 0n ? -size : size;
  };
  const zero = nanoseconds(cells[0][time]);
  const column = (name) => names.indexOf(name);
  let before;
  return cells.map((row, i) => {
    const numbers = (list) => list.map((name) => (row[column(name)] === '' ? NaN : Number(row[column(name)])));
    let q = numbers(['qw', 'qx', 'qy', 'qz']);
    if (before && q.reduce((sum, number, k) => sum + number * before[k], 0) < 0) q = q.map((number) => -number);
    before = q;
    const own = Object.fromEntries(parameters.filter((name) => column(name) >= 0).map((name) => [name, Number(row[column(name)])]));
    const difference = nanoseconds(row[time]) - zero;
    const t = Number(`${difference}e-27`);
    return { id: i + 1, row: i, t, q, p: column('px') < 0 ? null : numbers(['px', 'py', 'pz']), rates: column('wx') < 0 ? [] : [numbers(['wx', 'wy', 'wz'])], own };
  });
}

async function realRead() {
  const { load } = await import(pathToFileURL(`${process.env.ORISPLINE_NPM}/full.js`));
  const ori = await load();
  return (text, name) => {
    const track = ori.read(text, name);
    const columns = track.info.columns.map((column) => column.name);
    const of = (column) => (columns.includes(column) ? track.column(column, 'wxyz') : null);
    const rates = ['angular_velocities', 'angular_accelerations', 'angular_jerks'].filter((column) => columns.includes(column)).map((column) => triples(track.column(column)));
    const [q, p] = [of('orientations'), of('positions') && triples(of('positions'))];
    const own = parameters.filter((column) => columns.includes(column)).map((column) => [column, track.column(column)]);
    const keys = [...track.column('times')].map((t, i) => ({
      id: i + 1,
      row: i,
      t,
      q: [...q.slice(4 * i, 4 * i + 4)],
      p: p && p[i],
      rates: rates.map((rate) => rate[i]),
      own: Object.fromEntries(own.map(([column, values]) => [column, values[i]])),
    }));
    return { keys, epoch: track.info.epoch };
  };
}

const readWhole = process.env.ORISPLINE_NPM ? await realRead() : (text) => ({ keys: simpleRead(text) });

/** A method with its settings in one order, with numbers in one form, as far as a test needs it. */
const settled = (text) => {
  const [name, ...pieces] = text.split(':');
  return [name, ...pieces.map((piece) => piece.replace(/[^=,]+/g, (word) => (Number.isNaN(Number(word)) ? word : String(Number(word))))).sort()].join(':');
};

/** The method in the comment of a file; lists in it are values of the keys, other settings stand above the columns of their names. */
function openedAs(text, name) {
  const stated = /^\uFEFF?[ \t]*#[ \t]*orispline:(?:.*[ \t])?method=([^ \t\r\n]+)/m.exec(text)?.[1] ?? 'auto';
  const lists = [...stated.matchAll(/:(\w+)=([^:]+,[^:]+)/g)].map(([, one, values]) => [one, values.split(',').map(Number)]);
  const method = settled(stated.replace(/:\w+=[^:,]+,[^:]+/g, ''));
  const own = readWhole(text, name).keys.map((key, k) => ({
    ...Object.fromEntries(Object.entries(key.own).filter(([one]) => !method.includes(`:${one}=`))),
    ...Object.fromEntries(lists.map(([one, values]) => [one, values[k]])),
  }));
  return { method, own };
}

const reopens = ({ text, name, choice, own }) => {
  const opened = openedAs(text, name), wanted = [choice.method, ...Object.entries(choice.settings).map(([one, value]) => (value === true ? one : `${one}=${value}`))];
  return opened.method === settled(wanted.join(':')) && isDeepStrictEqual(opened.own, own);
};

/** Only files: what is asked beside these fails. `asked` has the names of all questions. */
export function fileEngine() {
  const asked = [];
  return {
    asked,
    async ask(name, given) {
      asked.push(name);
      if (name === 'read') return readWhole(given.text, given.name).keys;
      if (name === 'reopens') return reopens(given);
      if (name === 'write') return `all ${given.keys.length} keys anew`;
      throw new Error(name);
    },
  };
}

export const keysIn = (text, name = 'keys.csv') => readWhole(text, name).keys;
