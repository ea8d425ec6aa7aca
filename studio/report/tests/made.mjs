// SPDX-License-Identifier: Apache-2.0
// Reports that a test makes, in the template that was built.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, launch, open } from './browser.mjs';

const template = readFileSync(new URL('../dist/index.html', import.meta.url), 'utf8');

/** `reportWith(name, data, steps, options)`: a test of one report in a browser of this file of tests. */
export function reports() {
  const folder = mkdtempSync(join(tmpdir(), 'orispline-report-'));
  let browser;
  before(async () => (browser = await launch()));
  after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });
  return (name, data, steps, options = {}) =>
    test(name, async () => {
      const file = join(folder, 'report.html');
      writeFileSync(file, template.replace('__ORISPLINE_REPORT_DATA__', () => JSON.stringify(data).replaceAll('<', '\\u003c')));
      const page = await open(browser, file, options);
      await drawn(page);
      await steps(page);
      await page.finish();
    });
}

const zeros = (times) => times.flatMap(() => [0, 0, 0]);

/** Turns about z at a speed, at these times. */
export const turning = (times, speed, more = {}) => ({
  t: times,
  q: times.flatMap((t) => [Math.cos((speed * t) / 2), 0, 0, Math.sin((speed * t) / 2)]),
  w: times.flatMap(() => [0, 0, speed]),
  a: zeros(times),
  j: zeros(times),
  torque: [],
  p: [],
  error_t: [],
  error_deg: [],
  ...more,
});

export const method = (name, samples, more = {}) => ({ name, continuity: 'C2', failure: '', measures: {}, samples, keys: null, ...more });

export const keysAt = (times, speed) => ({ t: times, q: turning(times, speed).q, p: [] });

export const column = (id, more = {}) => ({ id, label: id, unit: 'deg', explanation: '', better: 'less', is_time: false, rounding: 0, ...more });

/** So many times from 0 to an end. */
export const spread = (count, end) => Array.from({ length: count }, (_, i) => (end * i) / (count - 1));
