// SPDX-License-Identifier: Apache-2.0
// What the builds of the pages share.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** The path of something beside this file, or in the folder above. */
export const placeOf = (path) => fileURLToPath(new URL(path, import.meta.url));

const licence = (name) => `${name}\n\n${readFileSync(placeOf(`node_modules/${name}/LICENSE`), 'utf8').trim()}`;

/** The licences of what is built into a page or a module. */
export const licences = (kind, ...more) => [`This ${kind} contains:`, licence('three'), licence('uplot'), ...more].join('\n\n');

/** A page with a policy by which the browser refuses every request. */
export const guarded = (html, { scripts = '', workers = '' } = {}) =>
  html.replace(
    '<meta charset="utf-8" />',
    `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'${scripts}; style-src 'unsafe-inline'; img-src data:${workers}" />`,
  );

/** A page with that policy, and the licences of what is built in. */
export const sealed = ({ notices, ...policy }) => ({
  name: 'sealed',
  transformIndexHtml: {
    order: 'post',
    handler: (html) => guarded(html, policy).replace('<!doctype html>', () => `<!doctype html>\n<!--\n${licences('page', ...notices)}\n-->`),
  },
});

const shaderText = /^((?:var|const) \S+ = )"(.*)";$/gm; // as three's modules are built

/** Without comments, and without spaces but those that part words and directives. */
const short = (shader) =>
  shader
    .replaceAll('\\t', ' ')
    .split('\\n')
    .map((line) => line.replace(/\/\/.*/, '').trim().replace(/ +/g, ' '))
    .filter(Boolean)
    .map((line) => (line.startsWith('#') ? line : line.replace(/ ?([-+*/=<>!&|,;:?(){}[\]]) ?/g, '$1')))
    .join('\\n');

/** The shaders of three as short as they can be: what makes scripts short leaves texts as they are. */
export const shortShaders = {
  name: 'short-shaders',
  transform: (code, id) => (id.endsWith('/three.module.js') ? { code: code.replace(shaderText, (_, start, shader) => `${start}"${short(shader)}";`), map: null } : null),
};

/** The sources of the npm package, of which the studio takes what it needs. */
export const library = { find: /^orispline\//, replacement: placeOf('../bindings/npm/src/') };
