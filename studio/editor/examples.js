// SPDX-License-Identifier: Apache-2.0
// For Vite: sources take in `examples/data/NAME?raw` of the repository. Where the studio is built elsewhere ORISPLINE_EXAMPLES names that folder.
import { existsSync } from 'node:fs';
import { basename, join } from 'node:path';

export const examples = () => ({
  name: 'examples',
  enforce: 'pre',
  resolveId(id) {
    const folder = process.env.ORISPLINE_EXAMPLES;
    const file = folder && /\/examples\/data\/[^/]+\?raw$/.test(id) && join(folder, basename(id).replace('?raw', ''));
    return file && existsSync(file) ? `${file}?raw` : null;
  },
});
