// SPDX-License-Identifier: Apache-2.0
// The method of a curve, and why it has none where that is so.
import { element } from 'orispline-viewer/look/element';
import { names, type Which } from '../document/document';
import { methodText } from '../document/methodText';
import { sentence } from '../document/sentence';
import { withMethod } from '../edits/choice';
import type { Studio } from '../store/studio';

/** Its list has the titles of the methods; closed it shows the name, which is short. */
export function methodMenu({ store, methods }: Studio, which: Which): HTMLElement {
  const name = element('span', { className: 'name', attributes: { 'aria-hidden': 'true' } });
  const options = methods.map(({ name, title }) => element('option', { value: name, title }, `${name} – ${title}`));
  const select = element('select', { className: which, attributes: { 'aria-label': names[which] } }, ...options);
  select.onchange = () => {
    const method = methods.find(({ name }) => name === select.value);
    if (method) store.edit(withMethod(store.current().document, which, method));
  };
  store.subscribe(['document'], ({ document }) => {
    select.value = name.textContent = document[which].method;
    select.title = methods.find(({ name }) => name === select.value)?.title ?? '';
  });
  return element('span', { className: `named ${which}` }, select, name);
}

/** The reason, and what is seen meanwhile. */
export function refusal({ store }: Studio, which: Which): HTMLElement {
  const line = element('p', { className: `refusal ${which}`, attributes: { role: 'status' } });
  store.subscribe(['troubles', 'document'], ({ troubles, document }) => {
    const trouble = troubles[which];
    line.textContent = trouble ? `${methodText(document[which])} has no curve through these keys: ${sentence(trouble.message)} The last good one stays, in grey.` : '';
    line.hidden = !trouble;
  });
  return line;
}
