// SPDX-License-Identifier: Apache-2.0
// A page that the tests of a file open from the disk, in a browser that is there for all of them.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { launch, open } from '../../report/tests/browser.mjs';

/** Of a page that is built before the tests: what opens it, with options as `open` has them. */
export function opener(built) {
  let [browser, folder, file] = [];
  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'orispline-'));
    file = join(folder, 'studio.html');
    writeFileSync(file, await built());
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true });
  });
  return (options) => open(browser, file, options);
}
