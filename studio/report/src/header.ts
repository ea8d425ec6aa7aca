// SPDX-License-Identifier: Apache-2.0
// What the report is about, and the switch between light and dark.
import { breakable, element, place } from './element';
import { report } from './report';
import { choose, current, subscribe } from './state';

export function showHeader(): void {
  document.title = report.title;
  const toggle = element('button', {
    type: 'button',
    className: 'theme',
    onclick: () => choose({ theme: current().theme === 'dark' ? 'light' : 'dark' }),
  });
  const start = report.time_start && report.time_start !== '0' && `t = 0 at ${report.time_start} s`;
  const facts = [report.date, report.version && `orispline ${report.version}`, start].filter(Boolean).join(' · ');
  const lines = [facts, ...report.notes].filter(Boolean).map((text) => element('p', { className: 'facts' }, ...breakable(text)));
  const command = element('pre', { tabIndex: 0, attributes: { role: 'region', 'aria-label': 'The command that makes this report' } }, element('code', {}, report.command));
  place('header').append(element('div', {}, element('h1', {}, ...breakable(report.title)), ...lines), toggle, ...(report.command ? [command] : []));
  subscribe(['theme'], ({ theme }) => {
    document.documentElement.dataset.theme = theme;
    toggle.textContent = theme === 'dark' ? '☀ Light' : '☾ Dark';
  });
}
