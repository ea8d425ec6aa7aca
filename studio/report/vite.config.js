// SPDX-License-Identifier: Apache-2.0
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { sealed, shortShaders } from '../pages.js';

export default defineConfig({
  plugins: [shortShaders, viteSingleFile(), sealed()],
  build: { target: 'es2022', modulePreload: false, reportCompressedSize: false },
});
