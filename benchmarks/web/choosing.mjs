// SPDX-License-Identifier: Apache-2.0
// How long it takes to choose another method on a report, beside a page of the same data that an earlier template makes:
// node benchmarks/web/choosing.mjs PAGE [EARLIER_TEMPLATE]
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, open } from '../../studio/report/tests/browser.mjs';
import { documentOf } from '../../studio/report/tests/document.mjs';
import { plain } from './plain.mjs';

const [file, template] = process.argv.slice(2);
const rounds = 3; // of all methods, one page after the other
const document = documentOf(file);
const names = document.methods.filter(({ failure }) => !failure).map(({ name }) => name);

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** Milliseconds from each choice until the frame that shows it is painted, and until the plots are drawn too that are out of view. */
const choices = (page) =>
  page.locator('select.first').evaluate(async (select, names) => {
    const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    const times = { seen: [], all: [] };
    for (const name of names) {
      const start = performance.now();
      select.value = name;
      select.dispatchEvent(new Event('change'));
      await painted();
      times.seen.push(performance.now() - start);
      while (document.querySelector('[aria-busy]')) await painted();
      times.all.push(performance.now() - start);
    }
    return times;
  }, names);

const pages = { now: file };
if (template) {
  pages.before = join(mkdtempSync(join(tmpdir(), 'orispline-')), 'before.html');
  const json = JSON.stringify(plain(document)).replaceAll('<', '\\u003c');
  writeFileSync(pages.before, readFileSync(template, 'utf8').replace('__ORISPLINE_REPORT_DATA__', () => json));
}

const browser = await launch();
const opened = {};
for (const [name, path] of Object.entries(pages)) opened[name] = await open(browser, path, { viewport: { width: 1440, height: 900 } });
const times = Object.fromEntries(Object.keys(pages).map((name) => [name, { seen: [], all: [] }]));
for (let round = 0; round < rounds; ++round)
  for (const [name, page] of Object.entries(opened)) for (const [until, values] of Object.entries(await choices(page))) times[name][until].push(...values);
await browser.close();

const [seen, all] = [median(times.now.seen), median(times.now.all)];
console.log(`choosing one of ${names.length} methods, ${document.title}: ${seen.toFixed(1)} ms, ${all.toFixed(1)} with what is out of view, medians of ${times.now.all.length}`);
if (template) console.log(`the earlier page: ${median(times.before.all).toFixed(1)} ms; now ${(seen / median(times.before.seen)).toFixed(3)} of it, ${(all / median(times.before.all)).toFixed(3)} with what is out of view`);
else console.log('the earlier template is not in this history: no ratio');
