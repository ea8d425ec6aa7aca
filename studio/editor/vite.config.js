// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { library, placeOf, sealed, shortShaders } from '../pages.js';

const notices = [`The compiled library, and of what that contains:\n\n${readFileSync(placeOf('../THIRD_PARTY'), 'utf8').trim()}`];

/** The compiled library within the page, from the file that ORISPLINE_STUDIO_WASM names. */
const withModule = {
  name: 'with-module',
  transformIndexHtml: {
    order: 'post',
    handler(html) {
      const path = process.env.ORISPLINE_STUDIO_WASM;
      if (!path) throw new Error('found no ORISPLINE_STUDIO_WASM, wanted the path of studio.wasm; make studio builds it');
      return html.replace('__ORISPLINE_STUDIO_MODULE__', () => gzipSync(readFileSync(path), { level: 9 }).toString('base64'));
    },
  },
};

const { wanted } = JSON.parse(readFileSync(new URL('src/document/browsers.json', import.meta.url), 'utf8'));

/** Which browsers the page wants, in what it says to others. */
const withBrowsers = { name: 'with-browsers', transformIndexHtml: (html) => html.replace('__ORISPLINE_BROWSERS__', wanted) };

export default defineConfig({
  plugins: [shortShaders, viteSingleFile(), sealed({ notices, scripts: " 'wasm-unsafe-eval'", workers: '; worker-src blob:' }), withModule, withBrowsers],
  resolve: { alias: [library] },
  server: { fs: { allow: ['../..'] } },
  build: { target: 'es2022', modulePreload: false, reportCompressedSize: false },
});
