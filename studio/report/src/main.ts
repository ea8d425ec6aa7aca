// SPDX-License-Identifier: Apache-2.0
// The module of the pages: it shows a report where the page has the data of one, and is the widget where a notebook loads it.
export { default } from 'orispline-widget';
import { createViewer } from 'orispline-viewer';
import { readPage } from './data';

const data = document.querySelector('head > #report-data');
if (data) {
  const report = readPage(data.textContent ?? '');
  document.title = report.title;
  const viewer = createViewer(document.querySelector('main')!, report, { keys: document });
  Object.assign(globalThis, { viewer }); // for those who want what it shows, such as tests
  viewer.subscribe(['theme'], ({ theme }) => (document.documentElement.dataset.theme = theme));
}
