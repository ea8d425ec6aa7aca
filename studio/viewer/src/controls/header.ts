// SPDX-License-Identifier: Apache-2.0
// What the report is about, and the switch between light and dark.
import { breakable, element } from '../look/element';
import type { Store } from '../store/store';

export function headerOf({ report, choose, current, subscribe }: Store): HTMLElement {
  const toggle = element('button', {
    type: 'button',
    className: 'theme',
    onclick: () => choose({ theme: current().theme === 'dark' ? 'light' : 'dark' }),
  });
  subscribe(['theme'], ({ theme }) => (toggle.textContent = theme === 'dark' ? '☀ Light' : '☾ Dark'));
  const start = report.time_start && report.time_start !== '0' && `t = 0 at ${report.time_start} s`;
  const facts = [report.date, report.version && `orispline ${report.version}`, start].filter(Boolean).join(' · ');
  const paragraph = (className: string) => (text: string) => element('p', { className }, ...breakable(text));
  const lines = [...report.warnings.map(paragraph('warning')), ...[facts, ...report.notes].filter(Boolean).map(paragraph('facts'))];
  const command = element('pre', { tabIndex: 0, attributes: { role: 'group', 'aria-label': 'The command that makes this report' } }, element('code', {}, report.command));
  return element('div', { className: 'head' }, element('div', {}, ...(report.title ? [element('h1', {}, ...breakable(report.title))] : []), ...lines), toggle, ...(report.command ? [command] : []));
}
