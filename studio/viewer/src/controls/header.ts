// SPDX-License-Identifier: Apache-2.0
// What the report is about, and the switch between light and dark.
import { breakable, element } from '../look/element';
import type { Store } from '../store/store';

const warningStart = 'Warning: ';
const fewNotes = 2; // are not folded

/** Behind their number, which a click opens. */
function folded(notes: HTMLElement[]): HTMLElement[] {
  if (notes.length <= fewNotes) return notes;
  return [element('details', { className: 'notes' }, element('summary', {}, `${notes.length} notes`), ...notes)];
}

export function headerOf({ report, choose, current, subscribe }: Store): HTMLElement {
  const toggle = element('button', {
    type: 'button',
    className: 'theme',
    onclick: () => choose({ theme: current().theme === 'dark' ? 'light' : 'dark' }),
  });
  subscribe(['theme'], ({ theme }) => (toggle.textContent = theme === 'dark' ? '☀ Light' : '☾ Dark'));
  const start = report.time_start && report.time_start !== '0' && `t\u00a0=\u00a00 at ${report.time_start}\u00a0s`;
  const facts = [report.date, report.version && `orispline ${report.version}`, start].filter(Boolean).join(' · ');
  const paragraph = (className: string) => (text: string) => element('p', { className }, ...breakable(text));
  const isWarning = (note: string) => note.startsWith(warningStart);
  const warnings = [...report.warnings, ...report.notes.filter(isWarning)];
  const notes = report.notes.filter((note) => !isWarning(note)).map(paragraph('facts'));
  const lines = [...(facts ? [paragraph('facts')(facts)] : []), ...warnings.map(paragraph('warning')), ...folded(notes)];
  const command = element('pre', { tabIndex: 0, attributes: { role: 'group', 'aria-label': 'The command that makes this report' } }, element('code', {}, report.command));
  return element('div', { className: 'head' }, element('div', {}, ...(report.title ? [element('h1', {}, ...breakable(report.title))] : []), ...lines), toggle, ...(report.command ? [command] : []));
}
