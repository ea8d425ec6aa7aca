// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

const licence = (name) => `${name}\n\n${readFileSync(new URL(`../node_modules/${name}/LICENSE`, import.meta.url), 'utf8').trim()}`;

/** The licences of what is built in, and a policy by which the browser refuses every request. */
const sealed = {
  name: 'sealed',
  transformIndexHtml: {
    order: 'post',
    handler: (html) =>
      html
        .replace('<!doctype html>', `<!doctype html>\n<!--\nThis page contains:\n\n${licence('three')}\n\n${licence('uplot')}\n-->`)
        .replace(
          '<meta charset="utf-8" />',
          `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:" />`,
        ),
  },
};

export default defineConfig({
  plugins: [viteSingleFile(), sealed],
  build: { target: 'es2022', modulePreload: false, reportCompressedSize: false },
});
