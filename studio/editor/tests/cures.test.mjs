// SPDX-License-Identifier: Apache-2.0
// What the library says, for whoever is at the page: without options, which nobody can type there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moduleOf } from './modules.mjs';

const { troubleOf } = await moduleOf('engine/trouble.ts');

test('what is said of options within sentences of the library is left out', () => {
  for (const [said, wanted] of [
    ['positions are kept but not checked; add `position_tolerance` LENGTH to bound them', 'positions are kept but not checked'],
    ['a second recording begins, wanted one, or `unwrap` if the clock came round', 'a second recording begins, wanted one'],
    ['2 steps are turned the short way; set `signs` to as-given to turn as the angles say', '2 steps are turned the short way'],
    ['put keys in between and set `signs` to as-given to turn as the angles say: a step must turn by less than 360°', 'put keys in between: a step must turn by less than 360°'],
    ['the times are taken as seconds; if they are microseconds, set `time_scale` to 1e-6', 'the times are taken as seconds; they may be microseconds'],
    ['the most smoothing was taken; set `smoothing_time` to have less', 'the most smoothing was taken'],
    ['the least was taken, because hardly any noise was found or because `noise` is too small; set `smoothing_time` for more or less', 'the least was taken, because hardly any noise was found'],
    ['10 of 100 samples are rejected as outliers; if they are motion, set `loss` to l2, or `huber`', '10 of 100 samples are rejected as outliers'],
    ['found a BVH file, which is not read as rows; it is read with `input_format` bvh, or without that option under a name that ends in .bvh', 'found a BVH file, which is not read as rows; the studio edits one track; the command orispline studio makes a page of one joint of a skeleton'],
    ['it says `some_thing` else', 'it says some thing else'],
  ]) assert.equal(troubleOf({ message: said }).message, wanted);
});

test('what would mend a file goes with what is said of it', () => {
  assert.deepEqual(troubleOf({ message: 'No.', line: 3, column: 2, key: 1, option: 'columns', remedy: 'fps' }), { message: 'No.', line: 3, column: 2, key: 1, option: 'columns', remedy: 'fps' });
  assert.equal(troubleOf({ message: 'the matrix is no rotation; `normalise` takes the nearest rotation' }).remedy, 'normalise');
  assert.equal(troubleOf({ message: 'the times are taken as milliseconds; set `time_scale` if they are not' }).remedy, 'time_scale');
  assert.deepEqual(troubleOf('a text'), { message: 'a text' });
});
