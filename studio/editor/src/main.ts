// SPDX-License-Identifier: Apache-2.0
// The page of the studio.
import { startEngine } from './engine/start';

const main = document.querySelector('main')!;
startEngine().ask('methods', null).then(
  (methods) => (main.textContent = `The library is here, with ${methods.length} methods.`),
  ({ message }) => (main.textContent = message),
);
