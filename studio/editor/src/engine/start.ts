// SPDX-License-Identifier: Apache-2.0
import { WorkerEngine } from './client';
import type { Engine } from './protocol';
import StudioWorker from './worker?worker&inline';

/** The engine of this page, with the library that is within it. */
export const startEngine = (): Engine => new WorkerEngine(() => new StudioWorker(), document.getElementById('studio-module')?.textContent ?? '');
