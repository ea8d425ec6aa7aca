// SPDX-License-Identifier: Apache-2.0
// The compiled code that a page has within it.
import type { OrisplineError } from 'orispline/errors';
import { moduleOf } from 'orispline/wasm';
import browsers from '../document/browsers.json';

async function unpacked(base64: string): Promise<ArrayBuffer> {
  try {
    const bytes = Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
    return await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  } catch (reason) {
    throw new Error(`The library in this page cannot be unpacked (${(reason as Error).message}), so the page is not whole; take it anew.`);
  }
}

/** The module of the bytes of its .wasm, compressed by gzip and written as base64. */
export async function moduleIn(base64: string): Promise<WebAssembly.Module> {
  if (typeof DecompressionStream !== 'function') throw new Error(`This browser cannot unpack the library that is in this page: it wants ${browsers.wanted}.`);
  try {
    return await moduleOf({ wasm: await unpacked(base64) }, new URL('about:blank'));
  } catch (reason) {
    const isOld = (reason as Partial<OrisplineError>).code === 'not_supported';
    throw isOld ? new Error(`found no WebAssembly with SIMD here, wanted ${browsers.wanted}`) : reason; // the package alone runs in older ones
  }
}
