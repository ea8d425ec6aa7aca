// SPDX-License-Identifier: Apache-2.0
// methods.mjs FAMILIES: what the registry says of the methods that the header FAMILIES lists, as a source of the package. The list of all of them comes in,
// from `orispline methods --json`.
import { readFileSync } from 'node:fs';

const list = readFileSync(process.argv[2], 'utf8').match(/std::tuple<([^>]*)>/)[1];
const letters = (name) => name.replace(/.*::/, '').replaceAll('-', '').toLowerCase();
const all = JSON.parse(readFileSync(0, 'utf8'));
const methods = list.split(',').map((family) => all.find(({ name }) => letters(name) === letters(family.trim())));
if (methods.includes(undefined)) throw new Error(`found ${list}, wanted families that the registry knows`);
process.stdout.write(`// SPDX-License-Identifier: Apache-2.0
import type { MethodInfo } from './orispline.js';

export const methods: MethodInfo[] = ${JSON.stringify(methods)};
`);
