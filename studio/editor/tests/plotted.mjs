// SPDX-License-Identifier: Apache-2.0
// What is plotted, to be held to what the command and programs sample: bit by bit.
import assert from 'node:assert/strict';

export const methodText = ({ method, settings }) => [method, ...Object.entries(settings).flatMap(([name, value]) => (value === false ? [] : value === true ? name : `${name}=${value}`))].join(':');

/** Of the plotted samples those at even times. Where a key is at such a time, its right side is. */
export function evenOnes({ t }, count) {
  const inner = new Set(t.filter((time, i) => time === t[i + 1])); // keys: both sides
  const [others, right] = [[], []];
  t.forEach((time, i) => {
    if (!inner.has(time)) others.push(i);
    else if (t[i + 1] !== time) right.push(i);
  });
  const offGrid = (i) => Math.abs((((t[i] - t[0]) * (count - 1)) / (t.at(-1) - t[0])) - Math.round(((t[i] - t[0]) * (count - 1)) / (t.at(-1) - t[0])));
  const onGrid = right.toSorted((one, other) => offGrid(one) - offGrid(other)).slice(0, count - others.length);
  return [...others, ...onGrid].sort((one, other) => one - other);
}

export const same = (some, others) => some.every((value, i) => Object.is(value, others[i]));

/** In the page: what is edited and plotted. */
export const state = ({ store }) => {
  const { document, curves, troubles } = store.current();
  const drawn = curves.first;
  const lists = 'trouble' in drawn ? {} : Object.fromEntries(['t', 'q', 'w', 'a', 'j', 'p'].map((name) => [name, [...drawn[name]]]));
  return { document, troubles, lists, count: Math.max(600, 4 * document.keys.length + 1) };
};

const parts = { q: ['qw', 'qx', 'qy', 'qz'], w: ['wx', 'wy', 'wz'], a: ['ax', 'ay', 'az'], j: ['jx', 'jy', 'jz'], p: ['px', 'py', 'pz'] };

/** Columns of a table. */
export function columnsOf(text) {
  const [header, ...rows] = text.trim().split('\n').map((row) => row.split(','));
  return Object.fromEntries(header.map((column, i) => [column, rows.map((row) => Number(row[i]))]));
}

/** Columns that lists of samples are. */
export const columnsOfLists = (lists) =>
  Object.fromEntries(Object.entries(parts).flatMap(([name, columns]) => (lists[name] ? columns.map((column, i) => [column, Array.from({ length: lists[name].length / columns.length }, (_, k) => lists[name][columns.length * k + i])]) : [])));

/** Holds columns of samples at even times to those that were plotted. */
export function checkPlotted({ lists, count }, told, who) {
  const places = evenOnes(lists, count);
  for (const column of ['qw', 'wz']) assert.ok(told[column], `${who}: ${column} is not told`);
  for (const [name, columns] of Object.entries(parts))
    for (const [part, column] of columns.entries()) {
      if (lists[name].length === 0 || !told[column]) continue;
      const plotted = places.map((i) => lists[name][columns.length * i + part]);
      assert.equal(plotted.length, told[column].length);
      const wrong = plotted.findIndex((value, i) => !Object.is(value, told[column][i]));
      assert.equal(wrong, -1, `${who}: ${column} of sample ${wrong}: plotted ${plotted[wrong]}, found ${told[column][wrong]}`);
    }
}
