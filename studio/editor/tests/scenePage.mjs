// SPDX-License-Identifier: Apache-2.0
// A page with both scenes of the studio and nothing else: curves are great arcs between the keys, and there is no worker.
import { partsBuilt } from '../../viewer/tests/built.mjs';

const parts = `
import 'orispline-viewer/viewer';
import '../../editor/src/style/scene.css';
export { Store as View } from 'orispline-viewer/store/store';
export { reportOf } from 'orispline-viewer/data/report';
export { coloursOf, paint } from 'orispline-viewer/look/theme';
export { createStore } from '../../editor/src/store/store';
export { scenesOf } from '../../editor/src/scene/scenes';
`;

/** Runs in the page: makes \`studio\` of keys, each [t, q] or [t, q, p], and shows its scenes. */
function show(given) {
  const { View, reportOf, coloursOf, paint, createStore, scenesOf } = orispline;
  const keys = given.map(([t, q, p = null], i) => ({ id: i + 1, row: i, t, q, p, rates: [], own: {} }));
  const flat = (lists) => Float64Array.from(lists.flat());
  const none = new Float64Array();
  const method = (name, { keys }, shift) => {
    const path = { t: flat(keys.map(({ t }) => t)), q: flat(keys.map(({ q }) => q)), p: flat(keys.map(({ p }) => p ?? [])) };
    const samples = { ...path, t: path.t.map((t, i) => (i === 0 || i === keys.length - 1 ? t : t + shift)), w: none, a: none, j: none, torque: none, error_t: none, error_deg: none, straight: true, exactness_deg: null };
    return { name, continuity: '', failure: '', measures: {}, samples, keys: path, bands: {}, clock: null };
  };
  const reportFor = (document) => {
    const methods = [method('A auto', document, 0), method('B slerp', document, 0.15)];
    return reportOf({ body: 'box', first: 'A auto', second: 'B slerp', keys: methods[0].keys, methods });
  };
  const document_ = { version: 1, keys, first: { method: 'auto', settings: {} }, second: { method: 'slerp', settings: {} } };
  const store = createStore(document_);
  const view = new View(reportFor(document_));
  const studio = { store, view, engine: null, methods: [], original: { name: 'keys.csv', text: '', hash: '', epoch: '0' } };
  const root = Object.assign(document.createElement('main'), { className: 'orispline-viewer orispline-studio' });
  document.body.append(root);
  view.subscribe(['theme'], (state) => {
    root.dataset.theme = state.theme;
    paint(root, coloursOf(state));
  });
  view.atEnd(() => root.remove());
  const { body, sphere } = scenesOf(studio);
  const stages = Object.assign(document.createElement('div'), { className: 'stages' });
  stages.append(body, sphere);
  root.append(Object.assign(document.createElement('h1'), { textContent: 'Scenes' }), stages);
  view.atEnd(store.subscribe(['document'], ({ document }) => view.replace(reportFor(document))));
  view.choose({ time: keys[0].t });
  globalThis.studio = studio;
}

const layout = `
body { margin: 0; }
.orispline-studio { display: flex; flex-direction: column; gap: 12px; height: 520px; padding: 12px; box-sizing: border-box; }
.stages { flex: 1; grid-template: minmax(0, 1fr) / repeat(2, minmax(0, 1fr)); min-height: 0; }
.stages .frame { height: auto; }
@media (max-width: 700px) { .orispline-studio { height: 860px; } .stages { grid-template: repeat(2, minmax(0, 1fr)) / minmax(0, 1fr); } }
`;

/** The page as text. \`showKeys(keys)\` in it shows them. */
export async function scenePage() {
  const { script, style } = await partsBuilt(parts);
  const text = `${script.replaceAll('</script', '<\\/script')}\nglobalThis.showKeys = ${show};`;
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><link rel="icon" href="data:,"><title>Scenes</title><style>${style}${layout}</style></head><body><script>${text}</script></body></html>`;
}
