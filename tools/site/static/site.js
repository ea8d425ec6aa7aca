// SPDX-License-Identifier: Apache-2.0
// What the theme leaves out for a keyboard and a screen reader: names of its two side bars, and boxes that scroll can be scrolled by keys.
const named = { '.sidebar-drawer': 'All pages', '.toc-drawer': 'On this page' };

function reachScrolled() {
  for (const box of document.querySelectorAll('pre, .table-wrapper')) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute('tabindex');
  }
}

addEventListener('DOMContentLoaded', () => {
  for (const [place, name] of Object.entries(named)) document.querySelector(place)?.setAttribute('aria-label', name);
  reachScrolled();
});
addEventListener('load', reachScrolled);
addEventListener('resize', reachScrolled);
