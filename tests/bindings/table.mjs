// SPDX-License-Identifier: Apache-2.0
// table.mjs PACKAGE TABLE FOLDER: what the npm package finds for every request of the table, a line of JSON each.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const [place, tablePath, folder] = process.argv.slice(2);
const { load } = await import(join(place, 'full.js')), ori = await load();
const { files, requests } = JSON.parse(readFileSync(tablePath, 'utf8'));
const codes = ['', 'bad_data', 'bad_argument', 'not_converged', 'bad_access', 'cancelled', 'no_memory', 'fault'];

const ratesIn = (table) => {
  const rows = table.trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
  return { times: rows.map(([t]) => t), rates: rows.flatMap((row) => row.slice(1)) };
};

const inputOf = (name) => {
  const bytes = readFileSync(join(folder, name));
  if (files[name] === 'rates') return ratesIn(bytes.toString());
  return files[name] === 'skeleton' ? { bytes, name } : ori.read(bytes, name);
};

const inputsOf = (named) => {
  const inputs = {};
  for (const [name, file] of named) inputs[name] = name in inputs ? [inputs[name], inputOf(file)].flat() : inputOf(file);
  return inputs;
};

const found = ({ task, inputs, options }) => {
  try {
    const { document, summary, line, warnings, tracks, rates, skeletons } = ori.run(task, inputsOf(inputs), options);
    const made = [
      ...tracks.map((track) => ({ times: [...track.column('times')], orientations: [...track.column('orientations', 'wxyz')] })),
      ...rates.map(({ times, rates }) => ({ times: [...times], rates: [...rates] })),
      ...skeletons.map((skeleton) => ({ skeleton: Buffer.from(skeleton.write('made.glb').bytes).toString('base64') })),
    ];
    return { document, summary, line, warnings, made };
  } catch ({ code, message, option = '', remedy = '', key = -1 }) {
    const place = `${key < 0 ? '' : `key ${key}: `}${option ? `${option}: ` : ''}`;
    return { error: { code: codes.indexOf(code), message: message.slice(place.length), option, remedy, key } };
  }
};

for (const request of requests) process.stdout.write(`${JSON.stringify(found(request))}\n`);
