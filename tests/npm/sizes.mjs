// SPDX-License-Identifier: Apache-2.0
// How large the parts of the package are for who loads them, and what is wanted of each.
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';

export const parts = Object.entries(JSON.parse(readFileSync(join(import.meta.dirname, 'sizes.json'), 'utf8'))).map(([name, part]) => ({ name, ...part }));

export const isCompiled = (folder, { module }) => !module || existsSync(join(folder, module));

/** As servers send it. The best quality, 11, takes a second for 500 kB. */
const compressed = (bytes, quality = 11) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: quality } }).length;

/** Bytes of the minified script and of the module of a part of the package in `folder`, compressed by brotli. `tools`: where esbuild is. */
export const sizesOf = async (folder, tools, { entry, module, quality }) => {
  const { build } = createRequire(join(tools, 'x'))('esbuild');
  const { outputFiles } = await build({
    entryPoints: [join(folder, entry)], bundle: true, minify: true, format: 'esm', write: false, logLevel: 'silent', external: ['three'],
  });
  return { script: compressed(outputFiles[0].contents), module: module ? compressed(readFileSync(join(folder, module)), quality) : 0 };
};
