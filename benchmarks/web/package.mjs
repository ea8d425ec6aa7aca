// SPDX-License-Identifier: Apache-2.0
// What the npm package takes beside the native library and three.js, and how large it is, as JSON:
// node benchmarks/web/package.mjs PACKAGE TOOLS NATIVE: the built package, the node_modules of its tools, the program of native.cpp
import { join } from 'node:path';
import { isCompiled, parts, sizesOf } from '../../tests/npm/sizes.mjs';
import { curveRatios } from './curves.mjs';
import { mixerRatio } from './mixer.mjs';

const [folder, tools, program] = process.argv.slice(2);
if (!parts.every((part) => isCompiled(folder, part))) {
  console.error(`found no compiled modules in ${folder}, wanted those that make web compiles`);
  process.exit(1);
}
const entry = (name) => import(join(folder, `${name}.js`));
const [THREE, { load }, { load: loadLite }, { animate }] = await Promise.all([import(join(tools, 'three/build/three.module.js')), entry('index'), entry('lite'), entry('three')]);

const ratios = [...(await curveRatios(load, program)), await mixerRatio(THREE, loadLite, animate)];
const sizes = [];
for (const part of parts) sizes.push({ name: part.name, most: part.most, ...(await sizesOf(folder, tools, part)) });
console.log(JSON.stringify({ versions: `Node ${process.versions.node}, V8 ${process.versions.v8}, three.js ${THREE.REVISION}`, ratios, sizes }));
