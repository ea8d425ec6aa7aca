// SPDX-License-Identifier: Apache-2.0
// Files of every form, and every kind of edit: what is saved is the file with what was changed, it opens as what was seen, and what is undone is the file again.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answers, bytesOf } from './engine.mjs';
import { dice, moduleOf, tension } from './modules.mjs';

const edits = ['turn', 'time', 'keys', 'position', 'parameters'].map((name) => `edits/${name}.ts`);
const { savedText, ...edit } = await moduleOf('file/save.ts', ...edits);

const ask = answers();
const engine = { ask: async (name, given) => ask[name](given) };

const opened = (text, { name = 'keys.csv', reading } = {}) => ask.open({ bytes: bytesOf(text), name, ...(reading ? { reading } : {}) });
const options = (options, comma = false) => ({ reading: { options, comma } });

/** Cells of keys a second apart, with what beside them is to stay. */
const rows = (header, cells, { comment = '# as measured\n', times = cells.map((_, i) => `${i}.50`), by = ',' } = {}) =>
  `${comment}${['t', header, 'speed', 'label'].join(by)}\n${cells.map((cell, i) => [times[i], ...cell, (1.25 * i).toFixed(3), `mark ${i}`].join(by)).join('\n')}\n`;

const angles = [['0', '0', '0'], ['30', '20.5', '-10'], ['-45.25', '60', '170'], ['200', '-35', '12'], ['-12.125', '10', '1e1']];
const proper = angles.map(([a, b, c]) => [a, String(Math.abs(Number(b)) + 1), c]);
const inRadians = (cells) => cells.map((row) => row.map((cell) => (Number(cell) / 57).toFixed(5)));
const orders = ['ZYX', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'XYX', 'XZX', 'YXY', 'YZY', 'ZXZ', 'ZYZ'].flatMap((order) => [order, order.toLowerCase()]);

const quaternions = [['1', '0', '0', '0'], ['0.8', '0.6', '0', '0'], ['0.6', '0', '0.8', '0'], ['0.6', '0', '0', '0.8']];
const named = 'qw,qx,qy,qz';
const dated = (zone, between = 'T') => rows(named, quaternions, { times: ['00:00.5', '00:02', '00:03.25', '01:05'].map((time) => `2024-02-29${between}23:${time}${zone}`) });
const matrices = [[1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0, 0, 0, -1, 0, 1, 0], [0.28, 0, 0.96, 0, 1, 0, -0.96, 0, 0.28], [0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1]];

const forms = {
  ...Object.fromEntries(orders.map((order) => {
    const isProper = order[0] === order[2], cells = isProper ? proper : angles;
    return [`angles of the order ${order} in degrees`, [rows('e1_deg,e2_deg,e3_deg', cells), options({ euler: order })]];
  })),
  ...Object.fromEntries(orders.map((order) => [`angles of the order ${order} in radians`, [rows('e1,e2,e3', inRadians(order[0] === order[2] ? proper : angles)), options({ euler: order, angle_unit: 'rad' })]])),
  'roll, pitch and yaw': [rows('roll_deg,pitch_deg,yaw_deg', angles)],
  'yaw first, with units in brackets': [rows('Yaw [deg],Pitch [deg],Roll [deg]', angles)],
  'angles in thousandths of a radian': [rows('yaw_mrad,pitch_mrad,roll_mrad', angles)],
  'rotation vectors': [rows('rx,ry,rz', inRadians(angles))],
  'rotation vectors in degrees': [rows('rx_deg,ry_deg,rz_deg', angles)],
  matrices: [rows([...'123'].flatMap((i) => [...'123'].map((k) => `r${i}${k}`)).join(), matrices)],
  'dates in UTC': [dated('Z')],
  'dates with a zone': [dated('+02:00', ' ')],
  'dates without a zone': [dated('')],
  'days of the year': [dated('Z').replaceAll('2024-02-29', '2024-060')],
  'dates with Euler angles': [rows('roll_deg,pitch_deg,yaw_deg', angles, { times: angles.map((_, i) => `2026-03-01T12:0${i}:00.25Z`) })],
  frames: [rows(named, quaternions, { times: ['0', '12', '25', '48'] }).replace('\nt,', '\nframe,'), options({ fps: '24' })],
  'frames of television': [rows(named, quaternions, { times: ['30', '60', '90', '121'] }).replace('\nt,', '\nframe,'), options({ fps: '30000/1001' })],
  milliseconds: [rows(named, quaternions, { times: ['1000', '1500', '2250', '4000'] }).replace('\nt,', '\nt_ms,')],
  'a unit of times that was stated': [rows(named, quaternions, { times: ['0', '12', '25', '48'] }), options({ time_scale: '1/90000' })],
  'columns that were named': [rows('w,i,j,k', quaternions).replace('\nt,', '\nmoment,'), options({ columns: 't=moment,qw=w,qx=i,qy=j,qz=k' })],
  'decimal commas': [rows('qw;qx;qy;qz', quaternions, { by: ';' }).replaceAll('.', ','), options({}, true)],
  'tabs and decimal commas of angles': [rows('roll_deg\tpitch_deg\tyaw_deg', angles, { by: '\t' }).replaceAll('.', ','), options({}, true)],
  'positions in millimetres': [rows('qw,qx,qy,qz,px_mm,py_mm,pz_mm', quaternions.map((q, i) => [...q, String(i), '2.5', '0.1']))],
  TUM: ['# ground truth\n1.5 0 0 0 0 0 0 1\n2.5  1 0 0 0 0 0.6 0.8\n3.5 2 0 0 0 0 1 0\n4.75 2 1 0 0 0.6 0 0.8\n', { name: 'walk.tum', unnamed: true }],
  EuRoC: ['#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n1500000000,0,0,0,1,0,0,0\n2500000000,1,0,0,0.8,0.6,0,0\n3500000000,2,0,0,0,1,0,0\n', { unnamed: true }],
  'names in a comment': ['# made by a program\n# t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2.5,0.6,0,0.8,0\n4,0.6,0,0,0.8\n', { unnamed: true }],
  'no names': ['0,1,0,0,0\n1,0.8,0.6,0,0\n2.5,0.6,0,0.8,0\n4,0.6,0,0,0.8\n', { unnamed: true, ...options({ order: 'wxyz' }) }],
};

const kinds = {
  move: (document, random) => edit.movedInTime(document, document.keys[1].id, document.keys[1].t + 0.3 * (random() - 0.5)),
  'move the first': (document) => edit.movedInTime(document, document.keys[0].id, document.keys[0].t - 0.125),
  turn: (document, random) => edit.turnedInWorld(document, document.keys[2].id, [random() - 0.5, random() - 0.5, random() - 0.5]),
  'turn the first': (document, random) => edit.turnedInWorld(document, document.keys[0].id, [3 * random(), random() - 0.5, -2]),
  insert: (document) => edit.inserted(document, (document.keys[0].t + document.keys[1].t) / 2, { q: [0.5, 0.5, -0.5, 0.5], p: document.keys[0].p && [0.5, 0, 0.25] }).document,
  duplicate: (document) => edit.duplicated(document, document.keys.at(-1).id).document,
  'delete the first': (document) => edit.deleted(document, document.keys[0].id),
  delete: (document) => edit.deleted(document, document.keys[1].id),
  place: (document) => (document.keys[0].p ? edit.placed(document, document.keys[1].id, 1, 0.75) : document),
  pull: (document) => edit.withOwn({ ...document, first: { method: 'timed-c2', settings: {} } }, document.keys[1].id, 'first', tension, 0.25),
  method: (document) => ({ ...document, first: { method: 'timed-c2', settings: { ends: 'rest' } } }),
};

const isTurned = (some, other) => !some.every((x, i) => x === other[i]) && !some.every((x, i) => x === -other[i]);

/** What is written of a row that nobody has touched: the row; of the first one perhaps with the other sign, and with a column more where one was added. */
function checkRows(said, { original, document }, now, text, kind) {
  const lines = text.split('\n'), rowsOf = original.text.trimEnd().split('\n').slice(-document.keys.length);
  now.keys.forEach(({ row, t, q, p }, k) => {
    const was = document.keys[row];
    if (!was || was.t !== t || was.p !== p || isTurned(was.q, q)) return;
    const line = rowsOf[row];
    assert.ok(k === 0 || lines.some((one) => (kind === 'pull' ? one.startsWith(line) : one === line)), `${said}: the row of key ${k} stays`);
  });
  for (const line of original.text.split('\n').filter((one) => one.startsWith('#'))) assert.ok(lines.includes(line), `${said}: the comment stays`);
  for (const { row } of now.keys) if (row !== null && original.text.includes(`mark ${row}`)) assert.match(text, new RegExp(`${(1.25 * row).toFixed(3).replace('.', '[.,]')}[,;\t]mark ${row}`), `${said}: further columns stay`);
}

async function checkEdit(what, kind, found, random, { unnamed = false }) {
  const { original, document } = found, said = `${what}, ${kind}`, now = kinds[kind](document, random);
  const { text, isWhole } = await savedText(original, now, engine, document, 'other.csv');
  if (unnamed && kind === 'pull') return assert.equal(isWhole, true, said); // there is no place for the name of the column
  if (what === 'EuRoC' && isWhole) return assert.ok(now.keys.some(({ t }) => !Number.isInteger(1e9 * t)), said); // it has whole nanoseconds
  assert.equal(isWhole, false, `${said}: ${text}`);
  const { first, keys } = ask.open({ bytes: bytesOf(text), name: original.name, ...(original.reading ? { reading: original.reading } : {}) }).document;
  assert.deepEqual(first, now.first, said);
  assert.equal(keys.length, now.keys.length, said);
  const sign = Math.sign(keys[0].q.reduce((sum, x, i) => sum + x * now.keys[0].q[i], 0));
  keys.forEach((key, k) => {
    const { q, t, p, own } = now.keys[k];
    assert.ok(Math.abs(key.t + now.keys[0].t - t) <= 1e-15 * Math.max(1, Math.abs(t)), `${said}, key ${k}`);
    key.q.forEach((x, i) => assert.ok(Math.abs(sign * x - q[i]) <= 8 * Number.EPSILON, `${said}, key ${k}: ${key.q}, ${q}`));
    assert.deepEqual([key.p, key.own], [p, own], said);
  });
  checkRows(said, found, now, text, kind);
}

test('every form of files, every kind of edit', async () => {
  const random = dice(61);
  for (const [what, [text, how = {}]] of Object.entries(forms)) {
    const found = opened(text, how);
    assert.deepEqual(await savedText(found.original, found.document, engine, found.document), { text, isWhole: false }, what);
    for (const kind of Object.keys(kinds)) await checkEdit(what, kind, found, random, how);
  }
});
