// SPDX-License-Identifier: Apache-2.0
// What the studio takes while a key is dragged, as JSON: node benchmarks/web/studio.mjs PAGE NATIVE: the built page, the program of native.cpp.
// ORISPLINE_STUDIO_WASM names the compiled library of the page.
import { draggingRatios } from './dragging.mjs';
import { drawingRatios } from './drawing.mjs';

const [page, program] = process.argv.slice(2);
const { version, ratios } = await draggingRatios(page);
console.log(JSON.stringify({ version, ratios: [...ratios, ...(await drawingRatios(program))] }));
