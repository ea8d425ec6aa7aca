// SPDX-License-Identifier: Apache-2.0
// What the theme leaves out for a keyboard and a screen reader: names of its two side bars, buttons that open them, and boxes that
// keys can scroll.
const named = { '.sidebar-drawer': 'All pages', '.toc-drawer': 'On this page' };

function reachScrolled() {
  for (const box of document.querySelectorAll('pre, .table-wrapper')) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute('tabindex');
  }
}

/** The icons that open a side bar are labels of a box that is not shown, which no key reaches. */
function makeButton(label) {
  const box = document.getElementById(label.htmlFor);
  const button = Object.assign(document.createElement('button'), { type: 'button', className: label.className, innerHTML: label.innerHTML });
  button.setAttribute('aria-label', box.getAttribute('aria-label'));
  button.addEventListener('click', () => box.click());
  label.replaceWith(button);
}

addEventListener('DOMContentLoaded', () => {
  for (const [place, name] of Object.entries(named)) document.querySelector(place)?.setAttribute('aria-label', name);
  document.querySelectorAll('.nav-overlay-icon, .toc-overlay-icon').forEach(makeButton);
  reachScrolled();
});
addEventListener('load', reachScrolled);
addEventListener('resize', reachScrolled);
