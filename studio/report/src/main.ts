// SPDX-License-Identifier: Apache-2.0
// The page of a report: its data, given to a viewer.
import './page.css';
import { createViewer } from 'orispline-viewer';
import { readPage } from './data';

const report = readPage(document.getElementById('report-data')?.textContent ?? '');
document.title = report.title;
const viewer = createViewer(document.querySelector('main')!, report, { keys: document });
Object.assign(globalThis, { viewer }); // for those who want what it shows, such as tests
viewer.subscribe(['theme'], ({ theme }) => (document.documentElement.dataset.theme = theme));
