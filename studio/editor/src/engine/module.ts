// SPDX-License-Identifier: Apache-2.0
// The compiled code that a page has within it.
import { moduleOf } from 'orispline/wasm';

/** The module of the bytes of its .wasm, compressed by gzip and written as base64. */
export async function moduleIn(base64: string): Promise<WebAssembly.Module> {
  if (typeof DecompressionStream !== 'function')
    throw new Error('This browser cannot unpack the library that is in this page: it wants Chrome 91, Firefox 113, Safari 16.4 or newer.');
  const packed = Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const bytes = new Response(unpacked).arrayBuffer();
  return moduleOf({ wasm: bytes }, new URL('about:blank'));
}
