// SPDX-License-Identifier: Apache-2.0
// The largest angle between two methods that the page of a report plots, and when: node tests/apart.mjs PAGE METHOD BESIDE
// Needs Chromium and no packages.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { documentIn } from '../report/tests/document.mjs';

/** Runs in the page, behind its own script. */
function largest(first, second) {
  const { viewer } = globalThis;
  viewer.choose({ first, second });
  const found = { angle: -1, time: NaN };
  for (const { t, values } of viewer.plotted('apart'))
    values.forEach((angle, i) => {
      if (angle > found.angle) Object.assign(found, { angle, time: t[i] });
    });
  return found;
}

/** A page that runs this says what it found in an attribute. */
const asking = (...names) =>
  `<script type="module">document.documentElement.dataset.found = JSON.stringify((${largest})(${names.map((name) => JSON.stringify(name).replaceAll('<', '\\u003c')).join(', ')}));</script>`;

const browser = process.env.CHROMIUM ?? 'chromium';
const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-3d-apis', '--no-first-run', '--disable-background-networking', '--dump-dom'];

/** Of the file of a page: the largest angle [deg], and its time [s]. */
export function apart(page, first, second) {
  const html = readFileSync(page, 'utf8');
  const { methods = [] } = documentIn(html);
  for (const name of [first, second]) if (!methods.some((method) => method.name === name && !method.failure)) throw new Error(`${page} has no method ${name}.`);
  const folder = mkdtempSync(join(tmpdir(), 'orispline-apart-'));
  try {
    const file = join(folder, 'page.html');
    writeFileSync(file, html.replace(/<\/body>\s*<\/html>\s*$/, () => `${asking(first, second)}</body></html>`));
    const shown = execFileSync(browser, [...flags, `--user-data-dir=${join(folder, 'profile')}`, pathToFileURL(file).href], { maxBuffer: 2 ** 28, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
    const found = /data-found="([^"]*)"/.exec(shown)?.[1];
    if (!found) throw new Error(`${page} was not opened by ${browser}.`);
    return JSON.parse(found.replaceAll('&quot;', '"'));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

if (process.argv[1] === import.meta.filename) {
  const [page, first, second] = process.argv.slice(2);
  if (!second) {
    console.error('apart: wanted PAGE METHOD BESIDE, such as r.html auto tcb');
    process.exit(2);
  }
  try {
    const { angle, time } = apart(page, first, second);
    console.log(angle < 0 ? `${first} and ${second} are not plotted against each other.` : `largest angle plotted between ${first} and ${second}: ${angle.toFixed(5)} deg at ${time.toFixed(4)} s`);
  } catch (error) {
    console.error(`apart: ${error.message}`);
    process.exit(1);
  }
}
