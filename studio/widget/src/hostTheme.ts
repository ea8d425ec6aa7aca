// SPDX-License-Identifier: Apache-2.0
// Whether the notebook around is light or dark, where it says so as JupyterLab does.

type Theme = 'light' | 'dark';

export function hostTheme(): Theme | undefined {
  const isLight = document.body.dataset.jpThemeLight;
  return isLight === undefined ? undefined : isLight === 'true' ? 'light' : 'dark';
}

/** Calls the update when it changes, until what it returns is called. */
export function watchHostTheme(update: (theme: Theme | undefined) => void): () => void {
  const observer = new MutationObserver(() => update(hostTheme()));
  observer.observe(document.body, { attributes: true, attributeFilter: ['data-jp-theme-light'] });
  return () => observer.disconnect();
}
