// SPDX-License-Identifier: Apache-2.0
// What the report is about, and the switch between light and dark.
import { element, place } from './element';
import { report } from './report';
import { choose, current, subscribe } from './state';

export function showHeader(): void {
  document.title = report.title;
  const toggle = element('button', {
    type: 'button',
    className: 'theme',
    onclick: () => choose({ theme: current().theme === 'dark' ? 'light' : 'dark' }),
  });
  const facts = [report.date, report.version && `orispline ${report.version}`, report.time_start && `t = 0 at ${report.time_start} s`];
  place('header').append(
    element('div', {}, element('h1', {}, report.title), element('p', { className: 'facts' }, facts.filter(Boolean).join(' · ')), ...report.notes.map((note) => element('p', { className: 'facts' }, note))),
    toggle,
    ...(report.command ? [element('pre', {}, element('code', {}, report.command))] : []),
  );
  subscribe(['theme'], ({ theme }) => {
    document.documentElement.dataset.theme = theme;
    toggle.textContent = theme === 'dark' ? '☀ Light' : '☾ Dark';
  });
}
