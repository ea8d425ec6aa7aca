// SPDX-License-Identifier: Apache-2.0
// run.mjs PROGRAM: runs a program of WebAssembly without files, with the exit code that it gives.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const wasi = new WASI({ version: 'preview1', returnOnExit: true });
const program = await WebAssembly.compile(await readFile(process.argv[2]));
process.exitCode = wasi.start(await WebAssembly.instantiate(program, wasi.getImportObject()));
