// SPDX-License-Identifier: Apache-2.0
// What goes between the page and the worker.
import type { Given, Name, Trouble } from './protocol';

/** The library first, as the page has it; then questions, each with a number of its own. */
export type Asked = { library: string } | { number: number; name: Name; given: Given<Name> };

/** The answer, and before it how much of it is done. */
export type Answered = { number: number } & ({ told: unknown } | { trouble: Trouble } | { share: number });
