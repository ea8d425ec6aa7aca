// SPDX-License-Identifier: Apache-2.0
// Lets `fetch` find the files beside an example, as a page finds those beside it.
import { readFile } from 'node:fs/promises';

globalThis.fetch = async (name) => new Response(await readFile(name));
