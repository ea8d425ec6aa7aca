// SPDX-License-Identifier: Apache-2.0
// The whole studio on an engine that needs no worker: its curves are great arcs between the keys, whatever the method.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const source = (path) => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

/** Runs in the page: an engine for a small CSV of t, qw, qx, qy, qz and perhaps px, py, pz. */
function stub() {
  const arc = (a, b, u) => {
    const dot = a.reduce((sum, value, i) => sum + value * b[i], 0);
    const angle = Math.acos(Math.min(Math.abs(dot), 1));
    const [s, r] = angle < 1e-9 ? [1 - u, u] : [Math.sin((1 - u) * angle) / Math.sin(angle), (Math.sign(dot) * Math.sin(u * angle)) / Math.sin(angle)];
    return a.map((value, i) => s * value + r * b[i]);
  };
  const at = (keys, t) => {
    const i = Math.min(Math.max(keys.findIndex((key) => key.t > t) - 1, 0), keys.length - 2);
    const k = keys[keys.length - 1].t <= t ? keys.length - 2 : i;
    const [a, b] = [keys[k], keys[k + 1]];
    const u = (t - a.t) / (b.t - a.t);
    return { q: arc(a.q, b.q, u), p: a.p && a.p.map((value, n) => (1 - u) * value + u * b.p[n]) };
  };
  const samples = (keys, bend) => {
    const [start, end] = [keys[0].t, keys[keys.length - 1].t];
    const t = Float64Array.from({ length: 601 }, (_, i) => start + ((end - start) * i) / 600);
    const poses = Array.from(t, (time) => at(keys, time));
    const rate = (size) => Float64Array.from([...t].flatMap((time) => [size * Math.sin(time + bend), size * Math.cos(2 * time), 0.3 * size]));
    return { t, q: Float64Array.from(poses.flatMap(({ q }) => q)), w: rate(1), a: rate(4), j: rate(20), p: Float64Array.from(poses.flatMap(({ p }) => p ?? [])), orders: Int8Array.from(keys, (_, i) => (i === 0 || i === keys.length - 1 ? 3 : (i * 7 + bend) % 4)) };
  };
  const parameter = (name, usual, per_key = true) => ({ name, default: usual, min: -100, max: 100, per_key, ghosts: 0, tensor: false });
  const method = (name, title, more = {}) => ({ name, title, min_keys: 2, interpolates: true, support_keys: 4, continuity_uniform: 2, continuity_uneven: 2, closes: false, parameters: [], choices: [], ends: [], ...more });
  const ends = ['natural', 'repeat', 'clamped', 'rest'];
  const methods = [
    method('auto', 'Local C2 spline that takes its rates from the keys around', { parameters: [{ ...parameter('hold', 0, false), min: 0, max: 1 }] }),
    method('slerp', 'Spherical linear interpolation'),
    method('timed-c2', 'Local quintic spline, C2 in time', { parameters: [parameter('tension', 0.5), parameter('tension2', 1)], ends, closes: true }),
    method('quintic', 'Tan’s quintic G2 spline with tension', { parameters: [parameter('tension', 0.5)], ends, closes: true }),
    method('hermite-c1', 'Cubic Hermite curve through rates of the keys', { choices: [{ name: 'stencil', words: ['5', '3'], default: '5' }] }),
    method('refused', 'A method that refuses all keys'),
  ];
  const trouble = (message) => Promise.reject({ message });
  const listeners = [];
  const asked = [];
  const stops = [];
  const refusedFor = (remedy, message, line) => Promise.reject({ remedy, message, line });
  const open = ({ bytes, name, method = 'auto', beside = 'slerp', reading, hash }) => {
    const text = new TextDecoder().decode(bytes);
    const [head, ...rows] = (reading?.comma ? text.replaceAll(',', '.').replaceAll(';', ',') : text).trim().split('\n').filter((line) => !line.startsWith('#')).map((line) => line.split(','));
    if (head[0] === 'frame' && !reading?.options.fps) return refusedFor('fps', "the column 'frame' counts frames, wanted how many there are in a second", 1);
    if (head[0] === 'frame') head[0] = 't';
    if (head[0] === 'moment' && reading?.options.columns?.startsWith('t=moment')) head[0] = 't';
    if (head[0] === 'moment') return refusedFor('columns', "no column t, found 'moment,qw,qx,qy,qz'");
    const twice = rows.findIndex((row, i) => i > 0 && row[0] === rows[i - 1][0]);
    if (twice >= 0) return refusedFor('drop_duplicates', `duplicate time ${rows[twice][0]}, as in line ${twice + 1}, wanted increasing times`, twice + 2);
    if (head[0] !== 't') return trouble(`found no header, wanted one such as t,qw,qx,qy,qz`);
    const keys = rows.map((row, i) => ({ id: i + 1, row: i, t: Number(row[0]), q: row.slice(1, 5).map(Number), p: row.length > 5 ? row.slice(5, 8).map(Number) : null, rates: [], own: {} }));
    const original = { name, text, hash: hash ?? `${name}-${text.length}`, epoch: '0', ...(reading ? { reading } : {}) };
    if (keys.length > 1000) return Promise.resolve({ original, count: keys.length, hasPositions: keys[0].p !== null });
    return Promise.resolve({ original, document: { version: 1, keys, first: { method, settings: {} }, second: { method: beside, settings: {} } }, warnings: [] });
  };
  const answers = {
    methods: () => Promise.resolve(methods),
    open,
    // Recordings whose name says that they are noisy need 640 keys of slerp, or smoothed fewer of auto; slow ones take as long as one waits.
    reduce: async ({ bytes, name, tolerance, smooth = false, methods }, progress) => {
      if (!/^[\d.]+deg$/.test(tolerance)) return trouble(`Found the tolerance ${tolerance}, wanted one such as 0.1deg.`);
      progress?.(0.25);
      if (name.startsWith('slow')) await new Promise((_, stop) => stops.push(stop));
      const isRaw = name.startsWith('noisy') && !smooth, [head, ...rows] = new TextDecoder().decode(bytes).trim().split('\n');
      const kept = rows.filter((_, i) => i % (isRaw ? 2 : 100) === 0), made = await open({ bytes: new TextEncoder().encode([head, ...kept].join('\n')), name: name.replace('.csv', '_keys.csv') });
      const [method, other] = isRaw && !methods ? ['slerp', 'auto'] : ['auto', 'slerp'];
      return { count: kept.length + (methods ? 5 : 0), method, others: methods ? [] : [{ method: other, count: kept.length + 5 }], furthest: 0.0987, furthestPosition: null, smoothed: smooth ? { noise: 0.31, rms: 0.33 } : null, opened: { ...made, original: { ...made.original, text: '' }, document: { ...made.document, keys: made.document.keys.map((key) => ({ ...key, row: null })) } } };
    },
    at: ({ keys, time }) => Promise.resolve(at(keys, time)),
    write: ({ keys }) => Promise.resolve(['t,qw,qx,qy,qz', ...keys.map(({ t, q }) => [t, ...q].join())].join('\n')),
    read: ({ text, name, reading }) => open({ bytes: new TextEncoder().encode(text), name, reading }).then(({ document }) => document.keys),
    reopens: () => Promise.resolve(true),
    stated: () => trouble('It has no other forms.'),
    sample: ({ keys }) => Promise.resolve(samples(keys, 0)),
    bake: () => Promise.resolve('{}'),
    calmest: () => Promise.resolve(null),
    ofAnyTimes: () => Promise.resolve(null),
  };
  return {
    asked,
    ask: (name, given, progress) => (asked.push(name), answers[name](given, progress)),
    stop: () => stops.splice(0).forEach((stop) => stop({ message: 'It was stopped.' })),
    draw: (document) => queueMicrotask(() => {
      const drawn = (which, bend) => (document[which].method === 'refused' ? { trouble: { message: 'It refuses these keys.' } } : samples(document.keys, bend));
      const curves = { first: drawn('first', 0), second: drawn('second', 1) };
      for (const listener of listeners) listener(curves, document);
    }),
    onCurves: (listener) => listeners.push(listener),
    close: () => {},
  };
}

/** The page as text; `app` in it is the studio. */
export async function panelPage() {
  const lib = { entry: source('app.ts'), formats: ['iife'], name: 'orispline', cssFileName: 'style' };
  const [{ output }] = await build({ configFile: false, logLevel: 'error', build: { write: false, minify: false, target: 'es2022', lib } });
  const style = output.find(({ fileName }) => fileName.endsWith('.css')).source;
  const script = output.find(({ fileName }) => fileName.endsWith('.js')).code.replaceAll('</script', '<\\/script');
  const begin = `for (const habit of ['more', 'toured']) localStorage.setItem('orispline-studio-' + habit, '1'); globalThis.engine = (${stub})(); globalThis.app = new orispline.App(document.querySelector('main'), engine); globalThis.begin = (text, name = 'keys.csv', more = {}) => app.open({ bytes: new TextEncoder().encode(text), name, ...more }); app.begin(null);`;
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,"><title>Studio</title><style>${style}</style></head><body><main></main><script>${script}</script><script>${begin}</script></body></html>`;
}
