// SPDX-License-Identifier: Apache-2.0
// Sources of the studio, built for a test.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/** A module that needs no browser. */
export async function moduleOf(path) {
  const entry = fileURLToPath(new URL(`../src/${path}`, import.meta.url));
  const lib = { entry, formats: ['es'], name: 'orispline' };
  const [{ output }] = await build({ configFile: false, logLevel: 'error', build: { write: false, minify: false, target: 'es2022', lib } });
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}
