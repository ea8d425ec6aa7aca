// SPDX-License-Identifier: Apache-2.0
// Pages of long recordings: ORISPLINE_COMMAND names the command that writes them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, launch, open } from './browser.mjs';

const { ORISPLINE_COMMAND: command } = process.env;
const skip = !command && 'ORISPLINE_COMMAND names no command';
const largest = 12e6; // bytes of a page
const folder = mkdtempSync(join(tmpdir(), 'orispline-long-'));

let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** Turns about changing axes at 100 Hz, trembling by half a degree. */
function recording(samples) {
  const rows = Array.from({ length: samples }, (_, i) => {
    const t = i / 100;
    const turn = [Math.sin(0.3 * t), Math.sin(0.17 * t + 1), Math.sin(0.23 * t + 2)].map((angle, k) => angle + 0.005 * Math.sin(7919 * i * (k + 1)));
    const angle = Math.hypot(...turn);
    return [t, Math.cos(angle / 2), ...turn.map((part) => (part / angle) * Math.sin(angle / 2))].map((value) => value.toFixed(9)).join();
  });
  return `t,qw,qx,qy,qz\n${rows.join('\n')}\n`;
}

for (const samples of [1e5, 1e6])
  test(`the page of ${samples} keys opens, is not large, and says what it leaves out`, { skip }, async () => {
    const [keys, file] = [join(folder, 'keys.csv'), join(folder, 'page.html')];
    writeFileSync(keys, recording(samples));
    execFileSync(command, ['inspect', keys, '--method', 'auto', '--report', file], { stdio: ['ignore', 'ignore', 'pipe'] });
    const { size } = statSync(file);
    assert.ok(size <= largest, `${size} bytes`);
    const page = await open(browser, file);
    await drawn(page);
    assert.match(await page.locator('.orispline-viewer').textContent(), new RegExp(`Of the ${samples} keys 2000 are shown, evenly picked`));
    const facts = await page.locator('.plots .facts').innerText();
    assert.match(facts, /^Curves are drawn within [\d.]+°/);
    assert.match(facts, /Keys are marked where they are 12 px apart; zoom in to see all/);
    for (const id of ['angle', 'w', 'a', 'j']) {
      const lines = await page.evaluate((name) => viewer.plotted(name).map(({ values }) => values.filter(Number.isFinite).length), id);
      assert.ok(lines.length > 0 && lines.every((count) => count > 300), `${id}: ${lines}`);
    }
    await page.finish();
  });
