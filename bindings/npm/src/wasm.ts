// SPDX-License-Identifier: Apache-2.0
// Where the compiled code comes from: a file beside the script, or what the user gives.
import { OrisplineError, badArgument, optionsOf, shown } from './errors.js';

export interface LoadOptions {
  /** The compiled code itself, its bytes or a compiled module: for places that cannot fetch. */
  wasm?: WebAssembly.Module | BufferSource | PromiseLike<WebAssembly.Module | BufferSource>;
  /** Where its bytes are, if not beside the script: for bundlers that copy no file. */
  wasmUrl?: string | URL;
}

/** A function with one instruction of SIMD. */
const withSimd = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11);

const noAccess = (url: URL | string, reason: unknown): OrisplineError =>
  new OrisplineError('bad_access', `${url}: found no WebAssembly there (${reason}), wanted the .wasm of this package: give its place as wasmUrl`, { option: 'wasmUrl' });

/** The bytes of what holds some. */
export const bytesOf = (option: string, source: ArrayBuffer | ArrayBufferView): Uint8Array<ArrayBuffer> => {
  if (ArrayBuffer.isView(source)) return new Uint8Array(source.buffer as ArrayBuffer, source.byteOffset, source.byteLength);
  if (!(source?.byteLength >= 0)) throw badArgument(option, `found neither an ArrayBuffer nor an array of bytes, wanted one of them`);
  return new Uint8Array(source);
};

const isWasm = (bytes: Uint8Array): boolean => [0, 97, 115, 109].every((byte, k) => bytes[k] === byte);

/** Also of another realm, such as that of a frame. */
const isModule = (source: WebAssembly.Module | BufferSource): source is WebAssembly.Module =>
  Object.prototype.toString.call(source) === '[object WebAssembly.Module]';

const fetched = async (url: URL | string): Promise<BufferSource> => {
  try {
    if (String(url).startsWith('file:')) {
      // Node, whose fetch reads no files. By this way bundlers for browsers see no module of Node.
      const node = (globalThis as { process?: { getBuiltinModule?(name: string): { readFileSync(url: URL): Uint8Array<ArrayBuffer> } } }).process;
      if (node?.getBuiltinModule) return node.getBuiltinModule('node:fs').readFileSync(new URL(url));
    }
    const response = await fetch(url);
    if (!response.ok) throw response.status;
    const bytes = await response.arrayBuffer();
    // Servers that know no such file may answer with a page of theirs, as that of Vite does.
    if (!isWasm(new Uint8Array(bytes))) throw response.headers.get('content-type');
    return bytes;
  } catch (reason) {
    throw noAccess(url, reason instanceof Error ? reason.message : reason);
  }
};

const compiled = async (source: BufferSource): Promise<WebAssembly.Module> => {
  const bytes = bytesOf('wasm', source);
  if (!isWasm(bytes))
    throw new OrisplineError('bad_data', `found ${bytes.length} bytes that are no WebAssembly, wanted the .wasm of this package`, { option: 'wasm' });
  try {
    return await WebAssembly.compile(bytes);
  } catch (reason) {
    throw new OrisplineError('bad_data', `found WebAssembly that does not compile (${(reason as Error).message}), wanted the .wasm of this package`, { option: 'wasm' });
  }
};

/** The module that the user gives, else that of the file beside the script. */
export const moduleOf = async (options: LoadOptions, besideScript: URL): Promise<WebAssembly.Module> => {
  const { wasm, wasmUrl = besideScript } = optionsOf('options', options);
  if (typeof wasmUrl !== 'string' && !wasmUrl?.href) throw badArgument('wasmUrl', `found ${shown(wasmUrl)}, wanted a URL`);
  if (typeof WebAssembly !== 'object' || !WebAssembly.validate(withSimd))
    throw new OrisplineError('not_supported', 'found no WebAssembly with SIMD here, wanted Chrome 91, Firefox 89, Safari 16.4, Node 16.4 or newer');
  const source = (await wasm) ?? (await fetched(wasmUrl));
  return isModule(source) ? source : compiled(source);
};
