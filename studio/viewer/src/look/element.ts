// SPDX-License-Identifier: Apache-2.0
// Elements in one call each.

type Properties<Tag extends keyof HTMLElementTagNameMap> = Partial<
  Omit<HTMLElementTagNameMap[Tag], 'attributes' | 'style' | 'dataset' | 'children'>
> & { attributes?: Record<string, string> };

export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  { attributes = {}, ...properties }: Properties<Tag> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  Object.assign(made, properties);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** A text whose long names, such as those of files, break behind their parts and not in the middle of a word or a number. */
export const breakable = (text: string) =>
  text.split(/(?<=[/\\_,:]|[.-](?!\d))(?=\S)/).flatMap((part, i) => (i === 0 ? [part] : [document.createElement('wbr'), part]));

/** A menu with a label; tells what was chosen. */
export function menu(label: string, options: [value: string, text: string][], chosen: (value: string) => void): [HTMLElement, HTMLSelectElement] {
  const select = element('select', { onchange: () => chosen(select.value), attributes: { 'aria-label': label } }, ...options.map(([value, text]) => element('option', { value }, text)));
  return [element('label', { className: 'choice' }, element('span', {}, label), select), select];
}
