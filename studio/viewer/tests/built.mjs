// SPDX-License-Identifier: Apache-2.0
// Sources of the viewer, built for a test.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const source = (path) => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

async function outputOf(path, format) {
  const lib = { entry: source(path), formats: [format], name: 'orispline' };
  const [{ output }] = await build({ configFile: false, logLevel: 'error', build: { write: false, minify: false, target: 'es2022', lib } });
  return output;
}

/** A module that needs no browser. */
export async function moduleOf(path) {
  const [{ code }] = await outputOf(path, 'es');
  return import(`data:text/javascript,${encodeURIComponent(code)}`);
}

/** The viewer as a script, which makes `orispline.createViewer`, and its style. */
export async function viewerBuilt() {
  const output = await outputOf('viewer.ts', 'iife');
  return { script: output[0].code, style: output.find(({ fileName }) => fileName.endsWith('.css')).source };
}
