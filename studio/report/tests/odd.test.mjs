// SPDX-License-Identifier: Apache-2.0
// Reports with little in them. The template is the one that was built.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, faultsOf, launch, open, phone, tooWide } from './browser.mjs';

const template = readFileSync(new URL('../dist/index.html', import.meta.url), 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'orispline-page-'));
const nothing = { t: [], q: [], w: [], a: [], j: [], torque: [], p: [], error_t: [], error_deg: [] };
const two = { t: [0, 1], q: [1, 0, 0, 0, 0.8, 0, 0, 0.6] };
const samples = { ...two, w: [0, 0, 1, 0, 0, 1], a: [0, 0, 0, 0, 0, 0], j: [0, 0, 0, 0, 0, 0], torque: [], p: [], error_t: [], error_deg: [] };
const empty = {
  title: 'T',
  command: '',
  date: '',
  version: '',
  time_start: '',
  notes: [],
  body: 'box',
  keys: { ...two, p: [] },
  reference: null,
  marks: null,
  limits: {},
  units: {},
  columns: [{ id: 'cost', label: 'Cost', unit: '', explanation: '', better: 'less', is_time: false, rounding: 0 }],
  sorted_by: '',
  first: '',
  second: '',
  methods: [],
};
const method = (name, more) => ({ name, continuity: 'C0', failure: '', measures: { cost: 1 }, samples, keys: null, ...more });

let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const reportWith = (name, changes, steps, options = {}) =>
  test(name, async () => {
    const file = join(folder, 'report.html');
    writeFileSync(file, template.replace('__ORISPLINE_REPORT_DATA__', () => JSON.stringify({ ...empty, ...changes })));
    const page = await open(browser, file, options);
    await drawn(page);
    await steps(page);
    await page.finish();
  });

reportWith('without methods is a table without rows', {}, async (page) => {
  assert.equal(await page.locator('tbody tr').count(), 0);
  assert.equal(await page.locator('canvas').count(), 0);
});

reportWith('in which all methods failed shows why', { methods: [method('a', { failure: 'no', samples: nothing })] }, async (page) => {
  assert.equal(await page.locator('tr.failed td').last().textContent(), 'no');
  assert.equal(await page.locator('canvas').count(), 0);
});

reportWith('of one method without positions and without a reference shows it alone', { methods: [method('only')] }, async (page) => {
  assert.equal(await page.locator('.stages figure:visible').count(), 2);
  assert.equal(await page.locator('[data-quantity=error]').count(), 0);
  assert.equal(await page.locator('.controls label:has-text("Seen")').count(), 0);
});

const tensions = '0.3,0.7,-0.2,0.9,0.4,0.3,0.7,-0.2,0.9';
const alike = [`quintic:tension=${tensions},0.4`, `quintic:tension=${tensions},0.5`];
for (const options of [{}, phone])
  reportWith('of methods whose long names differ at their ends only shows all of them', { methods: alike.map((name) => method(name)) }, async (page) => {
    const shown = page.locator('tbody th, figure:is(.first, .second) strong');
    for (const text of await shown.allTextContents()) assert.ok(alike.includes(text), text);
    assert.deepEqual(await shown.evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.outerHTML)), []);
    assert.deepEqual(await tooWide(page), []);
  }, options);

const keys = { t: [0], q: [1, 0, 0, 0], p: [] };
const still = { t: [0], q: [1, 0, 0, 0], w: [0, 0, 0], a: [0, 0, 0], j: [0, 0, 0], torque: [], p: [], error_t: [], error_deg: [] };
reportWith('of one key has measures only, and says why', { keys, methods: [method('constant', { samples: still })] }, async (page) => {
  assert.equal(await page.locator('tbody tr').count(), 1);
  assert.equal(await page.locator('canvas').count(), 0);
  assert.match(await page.locator('.scenes').textContent(), /one key is where it is at all times/);
});

const whenSampled = [0, 0.9].flatMap((from) => Array.from({ length: 20 }, (_, i) => from + i / 1000));
const withHole = { ...samples, error_t: whenSampled, error_deg: whenSampled.map(() => 1) };
reportWith('draws no errors where nothing was measured', { methods: [method('a', { samples: withHole })] }, async (page) => {
  const [line] = await page.evaluate(() => viewer.plotted('error').map(({ t, values }) => ({ t: [...t], values: [...values] })));
  assert.deepEqual(line.t.filter((_, i) => Number.isNaN(line.values[i])).map((time) => time.toFixed(4)), ['0.4595']);
  assert.equal(line.t.length, whenSampled.length + 1);
  await page.evaluate(() => viewer.choose({ time: 0.5 }));
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /a –/);
});

const scattered = [method('gap', { measures: {} }), method('large', { measures: { cost: 9 } }), method('null', { measures: { cost: null } }), method('small', {})];
reportWith('sorts missing values to the end both ways', { methods: scattered, sorted_by: 'cost' }, async (page) => {
  const names = () => page.locator('tbody th').allTextContents();
  assert.deepEqual((await names()).slice(0, 2), ['small', 'large']);
  await page.locator('th[data-id=cost] button').click();
  assert.deepEqual((await names()).slice(0, 2), ['large', 'small']);
  assert.equal(await page.locator('td.number', { hasText: '–' }).count(), 2);
});

const count = 20000;
const times = Array.from({ length: count }, (_, k) => k / 100);
const crowd = { t: times, q: times.flatMap((t) => [Math.cos(t), 0, Math.sin(t), 0]), p: [] };
const lasting = { ...samples, t: [0, times.at(-1)] };
reportWith('of very many keys opens and plays', { keys: crowd, methods: [method('a', { samples: lasting })] }, async (page) => {
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('output').textContent) > 0.5);
});

const later = { ...samples, t: [0.25, 0.75], error_deg: [1, null] };
reportWith('of methods at other times shows both', { methods: [method('a'), method('b', { samples: later })] }, async (page) => {
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /a 1\.000/);
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /b 1\.000/);
});

/** How many pixels of a plot have about that colour, in a part of its width. */
const pixels = (page, quantity, colour, [from, to] = [0, 1]) =>
  page.locator(`[data-quantity=${quantity}] canvas`).evaluate(
    (canvas, { colour, from, to }) => {
      const { data } = canvas.getContext('2d').getImageData(from * canvas.width, 0, (to - from) * canvas.width, canvas.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) count += colour.every((value, k) => Math.abs(data[i + k] - value) < 16) && data[i + 3] > 200;
      return count;
    },
    { colour, from, to },
  );
const red = [0xb3, 0x26, 0x1e];
const grey = [0x7a, 0x7f, 0x87];

const heavy = { ...samples, torque: [0, 0, 2, 0, 0, 1] };
reportWith('with limits draws them where they belong', { methods: [method('a', { samples: heavy })], limits: { w: 1.5, torque: 3 } }, async (page) => {
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /limit 1\.5$/);
  assert.match(await page.locator('[data-quantity=torque] figcaption').textContent(), /a 2\.000.*limit 3$/);
  assert.ok((await pixels(page, 'w', red)) > 100);
  assert.ok((await pixels(page, 'torque', red)) > 100); // above all values, and still in the picture
  assert.doesNotMatch(await page.locator('[data-quantity=a] figcaption').textContent(), /limit/);
  assert.equal(await pixels(page, 'a', red), 0);
});

const marks = { label: 'rejected', t: [0.5], q: [0, 0, 0, 1], error_deg: [30] };
const withErrors = { ...samples, error_t: [0, 0.25, 1], error_deg: [0, 7, 1] };
const noted = { methods: [method('a', { samples: withErrors }), method('b')], marks, notes: ['One sample is <b>rejected</b>.'] };
reportWith('with marks crosses them, and says its notes', noted, async (page) => {
  assert.equal(await page.locator('.head p').last().textContent(), 'One sample is <b>rejected</b>.');
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /rejected/);
  assert.ok((await pixels(page, 'error', red)) > 10);
  await page.locator('input[type=range]').fill('0.3');
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /a 6\.600/); // at times of their own, on the line
  assert.doesNotMatch(await page.locator('[data-quantity=error] figcaption').textContent(), /b /);
});

const seven = { t: [0, 0.2, 0.4, 0.5, 0.6, 0.8, 1], q: Array.from({ length: 7 }, (_, i) => [Math.cos(i / 5), 0, 0, Math.sin(i / 5)]).flat(), p: [] };
reportWith('of methods with keys of their own marks those of the first', { methods: [method('a', { keys: seven }), method('b')] }, async (page) => {
  const picture = () => page.locator('[data-quantity=w] canvas').evaluate((canvas) => canvas.toDataURL());
  const withSeven = await picture();
  await page.locator('select.second').selectOption('');
  await drawn(page);
  assert.notEqual(await picture(), withSeven);
  const alone = await picture();
  await page.locator('select.first').selectOption('b');
  await drawn(page);
  assert.notEqual(await picture(), alone);
});

const gap = [null, null, null];
const broken = {
  ...nothing,
  t: [0, 0.25, 0.5, 0.75, 1],
  q: [1, 0, 0, 0, 0.8, 0, 0, 0.6, null, null, null, null, 0.6, 0, 0, 0.8, 0, 0, 0, 1],
  w: [0, 0, 1, 0, 0, 1, ...gap, 0, 0, 1, 0, 0, 1],
  a: [0, 0, 0, 0, 0, 0, ...gap, 0, 0, 0, 0, 0, 0],
  j: [0, 0, 0, 0, 0, 0, ...gap, 0, 0, 0, 0, 0, 0],
};
const pathWithGap = { t: broken.t, q: broken.q };
const zeros = Array(21).fill(0);
const whole = { ...samples, ...seven, w: zeros.map((_, i) => Number(i % 3 === 2)), a: zeros, j: zeros };
reportWith('with a gap shows nothing in it', { methods: [method('a', { samples: broken }), method('b', { samples: whole })], reference: pathWithGap }, async (page) => {
  const said = (quantity) => page.locator(`[data-quantity=${quantity}] figcaption`).textContent();
  const scene = page.locator('.stages figure.first .frame');
  await page.locator('input[type=range]').fill('0.1');
  assert.match(await said('w'), /a 1\.000/);
  const before = await scene.screenshot();
  await page.locator('input[type=range]').fill('0.5');
  await drawn(page);
  for (const quantity of ['angle', 'w', 'a', 'j']) assert.match(await said(quantity), /a –/);
  assert.match(await said('angle'), /reference –/);
  assert.ok((await pixels(page, 'angle', grey, [0.1, 0.3])) > 20);
  assert.equal(await pixels(page, 'angle', grey, [0.4, 0.7]), 0);
  assert.match(await said('w'), /b 1\.000/);
  assert.notDeepEqual(await scene.screenshot(), before);
}, { draws: true });

const measured = (id, changes) => ({ id, label: id, unit: 'deg', explanation: '', better: 'less', is_time: false, rounding: 0, ...changes });
const cell = (page, name, column) => page.locator(`tr[data-method="${name}"] td`).nth(column + 2);

reportWith('shows at first what it names', { methods: ['a', 'b', 'c'].map((name) => method(name)), first: 'c', second: 'b' }, async (page) => {
  assert.deepEqual((await page.locator('.stages figure figcaption').allTextContents()).slice(0, 2), ['c', 'b']);
  assert.equal(await page.locator('tr[data-method=c] .pick.first').getAttribute('aria-pressed'), 'true');
});

reportWith('shows the first two where what it names has no samples', { methods: ['a', 'b'].map((name) => method(name)), first: 'gone', second: 'a' }, async (page) => {
  assert.deepEqual((await page.locator('.stages figure figcaption').allTextContents()).slice(0, 2), ['a', 'b']);
});

const near = ['x', 'y', 'z'].map((name, i) => method(name, { measures: { cost: [2, 2.019, 2.021][i], gain: [100, 99.1, 98.9][i] } }));
reportWith('marks all that are within one per cent of the best', { methods: near, columns: [measured('cost'), measured('gain', { better: 'more' })] }, async (page) => {
  for (const column of [0, 1]) {
    const marked = await Promise.all(['x', 'y', 'z'].map((name) => cell(page, name, column).evaluate((one) => one.className)));
    assert.deepEqual(marked, ['number best', 'number best', 'number']);
  }
});

const exact = method('exact', { measures: { cost: 1.38e-33 } });
const noise = { ...samples, w: [0, 0, 1, 0, 1e-17, 1], a: [0, 0, 1e-16, 0, 0, 3e-15] };
reportWith('shows rounding errors as 0', { methods: [exact, method('far', { measures: { cost: 2.5e-10 }, samples: noise })], columns: [measured('cost', { rounding: 1e-12 })], first: 'far', second: 'exact' }, async (page) => {
  assert.equal(await cell(page, 'exact', 0).textContent(), '0');
  assert.equal(await cell(page, 'far', 0).textContent(), '250.0');
  assert.match(await page.locator('th[data-id=cost]').textContent(), /\[10⁻¹² deg\]/);
  await page.locator('input[type=range]').fill('1');
  await drawn(page);
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /x 0.*y 0.*z 1\.000/);
  assert.match(await page.locator('[data-quantity=a] figcaption').textContent(), /far 0exact 0$/);
});

const hours = { ...samples, t: [0, 7384.25] };
const peaks = { columns: [measured('max_at_s', { unit: 's', is_time: true, better: 'neither' })], keys: { ...two, t: hours.t, p: [] } };
const late = ['a', 'b'].map((name, i) => method(name, { samples: hours, measures: { max_at_s: [3723.4, 59.6][i] } }));
reportWith('tells moments as a clock, and leads to them', { ...peaks, methods: late }, async (page) => {
  assert.equal(await cell(page, 'a', 0).textContent(), '1:02:03');
  assert.equal(await cell(page, 'b', 0).textContent(), '1:00');
  assert.doesNotMatch(await page.locator('th[data-id=max_at_s]').textContent(), /\[s\]/);
  await cell(page, 'b', 0).getByRole('button').click();
  assert.equal(await page.locator('output').textContent(), '1:00');
  assert.equal(await page.locator('select.second').inputValue(), 'b');
});

const brief = { ...samples, t: [0, 0.02] };
reportWith('tells moments of a short motion with the decimals that they need', { ...peaks, keys: { ...two, t: brief.t, p: [] }, methods: [method('a', { samples: brief, measures: { max_at_s: 0.01234 } })] }, async (page) => {
  assert.equal(await cell(page, 'a', 0).textContent(), '0.01234 s');
});

const inDegrees = { units: { w: { unit: '°/s', size: Math.PI / 180 }, error: { unit: 'mrad', size: 0.18 / Math.PI } }, limits: { w: Math.PI / 2, error: 1.8 / Math.PI } };
reportWith('shows quantities and limits in the unit that was given', { ...inDegrees, methods: [method('a', { samples: withErrors })] }, async (page) => {
  await page.locator('input[type=range]').fill('0.3');
  assert.match(await page.locator('[data-quantity=w] figcaption').textContent(), /\[°\/s\].*a 57\.30.*limit 90$/);
  assert.match(await page.locator('[data-quantity=error] figcaption').textContent(), /\[mrad\].*a 115\.2.*limit 10$/);
  assert.match(await page.locator('[data-quantity=a] figcaption').textContent(), /\[rad\/s²\]/);
});

const long = (what) => `/home/somebody/${'averylong'.repeat(30)}${what}.csv`;
const endless = {
  title: `${long('keys')} against ${long('truth')}`,
  command: `orispline compare ${long('keys')}`,
  notes: [`Of ${long('keys')} all is shown.`],
  marks: { ...marks, label: long('mark') },
  columns: [measured(long('column'))],
  methods: [method(long('a'), { samples: withErrors }), method(long('b')), method('c', { failure: long('failure'), samples: nothing })],
};
reportWith('with very long names fits on a phone', endless, async (page) => {
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(await tooWide(page), []);
  assert.deepEqual(await faultsOf(page), []);
}, phone);
