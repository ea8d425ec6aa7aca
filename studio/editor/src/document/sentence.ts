// SPDX-License-Identifier: Apache-2.0

/** What the library says as a sentence, which ends. */
export const sentence = (text: string): string => (/[.!?…]$/.test(text.trim()) ? text.trim() : `${text.trim()}.`);
