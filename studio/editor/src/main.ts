// SPDX-License-Identifier: Apache-2.0
// The page of the studio.
import { App } from './app';
import { startEngine } from './engine/start';
import type { Given } from './frame/opening';

/** The keys that the command wrote into the page, if it did. */
function given(): Given | null {
  const text = document.getElementById('studio-data')?.textContent?.trim() ?? '';
  if (!text.startsWith('{')) return null;
  const { name, content, method, beside } = JSON.parse(text);
  return { bytes: Uint8Array.from(atob(content), (c) => c.charCodeAt(0)), name, method: method ?? undefined, beside: beside ?? undefined };
}

const place = document.querySelector('main');
if (place) {
  const studio = new App(place, startEngine());
  Object.assign(globalThis, { studio }); // for who looks into it from the console
  void studio.begin(given());
}
