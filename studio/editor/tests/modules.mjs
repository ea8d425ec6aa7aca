// SPDX-License-Identifier: Apache-2.0
// Sources of the studio that need no browser, built for a test; and what tests of the document share.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const source = (path) => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

/** One module with all that some sources export. */
export async function moduleOf(...paths) {
  const entry = source('all.virtual.ts');
  const all = {
    name: 'all',
    enforce: 'pre',
    resolveId: (id) => (id === entry ? entry : null),
    load: (id) => (id === entry ? paths.map((path) => `export * from ${JSON.stringify(source(path))};`).join('\n') : null),
  };
  const lib = { entry, formats: ['es'], name: 'orispline' };
  const [{ output }] = await build({ configFile: false, logLevel: 'error', plugins: [all], build: { write: false, minify: false, target: 'es2022', lib } });
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}

/** Numbers that look random, the same in every run; 0 to 1. */
export function dice(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** About z by these angles [rad], a second apart. */
export const keysOfAngles = (angles, more = () => ({})) =>
  angles.map((angle, i) => ({ id: i + 1, row: i, t: i, q: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)], p: null, rates: [], own: {}, ...more(i) }));

export const documentOf = (keys, first = { method: 'timed-c2', settings: {} }, second = { method: 'slerp', settings: {} }) => ({ version: 1, keys, first, second });

export const tension = { name: 'tension', default: 0.5, min: -100, max: 100 };

export const timedC2 = {
  name: 'timed-c2',
  parameters: [tension, { name: 'tension2', default: 1, min: -100, max: 100 }],
  choices: [],
  ends: ['natural', 'repeat', 'quadratic', 'cubic', 'clamped', 'rest'],
  closes: true,
};

export const tcb = {
  name: 'tcb',
  parameters: ['tension', 'continuity', 'bias'].map((name) => ({ name, default: 0, min: -100, max: 100 })),
  choices: [],
  ends: ['natural', 'handle'],
  closes: false,
};

export const shoemake = { name: 'shoemake', parameters: [], choices: [{ name: 'timing', words: ['time', 'published'], default: 'time' }], ends: ['natural'], closes: false };
