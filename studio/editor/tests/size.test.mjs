// SPDX-License-Identifier: Apache-2.0
// How large the studio is, compressed by gzip as servers send it, and how large it may be.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

const parts = JSON.parse(readFileSync(new URL('sizes.json', import.meta.url), 'utf8'));
const sizeOf = (place) => gzipSync(readFileSync(process.env[place]), { level: 9 }).length;

for (const [name, { place, most }] of Object.entries(parts))
  test(`the ${name} has at most ${most} bytes`, (context) => {
    const size = sizeOf(place);
    context.diagnostic(`${size} bytes`);
    assert.ok(size <= most, `${size} bytes`);
  });
