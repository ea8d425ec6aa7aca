// SPDX-License-Identifier: Apache-2.0
// The data in the file of a page.
import { readFileSync } from 'node:fs';

export const documentIn = (html) => JSON.parse(/id="report-data">(.*?)<\/script>/s.exec(html)?.[1] ?? '{}');
export const documentOf = (file) => documentIn(readFileSync(file, 'utf8'));
