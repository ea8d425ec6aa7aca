export interface LoadOptions {
    /** The compiled code itself, its bytes or a compiled module: for places that cannot fetch. */
    wasm?: WebAssembly.Module | BufferSource | PromiseLike<WebAssembly.Module | BufferSource>;
    /** Where its bytes are, if not beside the script: for bundlers that copy no file. */
    wasmUrl?: string | URL;
}
/** The bytes of what holds some. */
export declare const bytesOf: (option: string, source: ArrayBuffer | ArrayBufferView) => Uint8Array<ArrayBuffer>;
/** The module that the user gives, else that of the file beside the script. */
export declare const moduleOf: (options: LoadOptions, besideScript: URL) => Promise<WebAssembly.Module>;
