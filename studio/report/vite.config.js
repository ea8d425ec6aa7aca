// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';
import { guarded, licences, placeOf, shortShaders } from '../pages.js';

const entry = 'src/main.ts';

/** In a page a script ends at its first end, and begins again at the start of a comment, also within its texts. */
const withoutEnds = (script) => script.replace(/<(\/script|!--)/gi, '\\x3C$1');

/** The module and its style within the page, and no file beside it. */
const inOnePage = {
  name: 'in-one-page',
  enforce: 'post',
  generateBundle(_, bundle) {
    const built = (end) => Object.values(bundle).find(({ fileName }) => fileName.endsWith(end));
    const script = `/*!\n${licences('module')}\n*/\n${withoutEnds(built('.js').code.trim())}`;
    const style = built('.css').source.trim();
    const source = guarded(readFileSync(placeOf('report/index.html'), 'utf8'))
      .replace('</head>', () => `  <style id="viewer">${style}</style>\n  </head>`)
      .replace(`<script type="module" src="/${entry}">`, () => `<script type="module">${script}`);
    for (const name of Object.keys(bundle)) delete bundle[name];
    this.emitFile({ type: 'asset', fileName: 'index.html', source });
  },
};

export default defineConfig({
  plugins: [shortShaders, inOnePage],
  build: {
    target: 'es2022',
    reportCompressedSize: false,
    lib: { entry, formats: ['es'], cssFileName: 'viewer' },
    rolldownOptions: { output: { minify: true } },
  },
});
