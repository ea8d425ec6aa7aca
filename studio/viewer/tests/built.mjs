// SPDX-License-Identifier: Apache-2.0
// Sources of the viewer, built for a test.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const source = (path) => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

async function outputOf(entry, format, ...plugins) {
  const lib = { entry, formats: [format], name: 'orispline', cssFileName: 'style' };
  const [{ output }] = await build({ configFile: false, logLevel: 'error', plugins, build: { write: false, minify: false, target: 'es2022', lib } });
  return output;
}

/** A module that needs no browser. */
export async function moduleOf(path) {
  const [{ code }] = await outputOf(source(path), 'es');
  return import(`data:text/javascript,${encodeURIComponent(code)}`);
}

const pageOf = (output) => ({ script: output[0].code, style: output.find(({ fileName }) => fileName.endsWith('.css'))?.source ?? '' });

/** The viewer as a script, which makes `orispline.createViewer`, and its style. */
export const viewerBuilt = async () => pageOf(await outputOf(source('viewer.ts'), 'iife'));

/** What a text exports, as a script with its style; it may import any part of the studio. */
export async function partsBuilt(text) {
  const entry = fileURLToPath(new URL('parts.ts', import.meta.url)); // is not there
  return pageOf(await outputOf(entry, 'iife', { name: 'parts', enforce: 'pre', resolveId: (id) => (id === entry ? id : undefined), load: (id) => (id === entry ? text : undefined) }));
}
