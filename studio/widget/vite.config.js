// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';
import { shortShaders } from '../pages.js';

const licence = (name) => `${name}\n\n${readFileSync(new URL(`../node_modules/${name}/LICENSE`, import.meta.url), 'utf8').trim()}`;
const banner = `// SPDX-License-Identifier: Apache-2.0\n/*! This module contains:\n\n${licence('three')}\n\n${licence('uplot')}\n*/`;

export default defineConfig({
  plugins: [shortShaders],
  build: {
    target: 'es2022',
    reportCompressedSize: false,
    lib: { entry: 'src/widget.ts', formats: ['es'], fileName: () => 'widget.js', cssFileName: 'widget' },
    rolldownOptions: { output: { minify: true, postBanner: banner } },
  },
});
