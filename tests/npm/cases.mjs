// SPDX-License-Identifier: Apache-2.0
// The cases that the C interface is held to, tests/c/cases.json, for a library that was loaded, in Node or in a page.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export const cases = JSON.parse(readFileSync(join(import.meta.dirname, '../c/cases.json'), 'utf8'));

/** What differs from the cases, a line each; `bulk`: whether its samples have the bits of those in bulk. */
export const differencesFrom = (cases, library, bulk) => {
  const codes = ['', 'bad_data', 'bad_argument', 'not_converged', 'bad_access', 'cancelled', 'no_memory', 'fault'];
  const numbers = (list) => list.map((number) => number ?? NaN);
  const keysOf = ({ times, orientations, columns: { positions } }) =>
    ({ times: numbers(times), orientations: numbers(orientations), order: 'wxyz', ...(positions && { positions: numbers(positions) }) });
  const known = new Map(library.methods().map((info) => [info.name, info])), keys = keysOf(cases.keys), times = numbers(cases.times);
  const found = [];
  const compare = (what, one, other) => {
    if (one.length !== other.length || !other.every((number, i) => Object.is(number, one[i]) || number === one[i])) found.push(`${what}: found ${one}, wanted ${other}`);
  };
  /** The column of tensions is for the methods that have some. */
  const settingsOf = (method) => (known.get(method.split(':')[0]).parameters.some(({ name }) => name === 'tension') ? { tension: cases.keys.columns.tension } : {});
  for (const { method, motions, left, samples } of cases.curves.filter(({ method }) => known.has(method.split(':')[0]))) {
    const curve = library.curve(method, keys, settingsOf(method)), made = curve.sample({ times, rates: 3 });
    times.forEach((time, i) => compare(`${method} at ${time}`, Object.values(curve.motion(time)).flat(), numbers(motions[i])));
    compare(`${method} before ${times[0]}`, Object.values(curve.motion(times[0], 'left')).flat(), numbers(left));
    if (!bulk) continue;
    for (const [name, mine] of [['orientation', made.orientations], ['angular_velocity', made.angularVelocities], ['angular_acceleration', made.angularAccelerations], ['angular_jerk', made.angularJerks], ['position', made.positions]])
      compare(`${method}, ${name}`, [...mine], numbers(samples[name]));
  }
  for (const { keys: stated, method = 'auto', error: wanted } of cases.faults) {
    if (stated?.columns.tension) continue; // which is a setting here, and may be one number
    const name = method.split(':')[0];
    if (!known.has(name) && cases.curves.some((curve) => curve.method === name)) continue; // which the small package lacks
    const text = JSON.stringify(wanted), isOwn = stated?.columns.positions; // lengths are checked by the script, in its words
    try {
      library.curve(method, stated ? keysOf(stated) : keys);
      found.push(`found no error, wanted ${text}`);
    } catch ({ code, key = -1, option = '', remedy = '', message }) {
      const isSame = code === codes[wanted.code] && key === wanted.key && option === wanted.option && remedy === wanted.remedy;
      if (!isSame || (bulk && !isOwn && !message.endsWith(wanted.message))) found.push(`found ${JSON.stringify({ code, key, option, remedy, message })}, wanted ${text}`);
    }
  }
  return found;
};
