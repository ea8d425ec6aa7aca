// SPDX-License-Identifier: Apache-2.0
// The library's cures are options, which nobody can type on the page: it offers to do what they do, so that its sentences leave them out.

const ofSkeletons = /(?:it|glTF) is read with `input_format` (\w+), or without that option under a name that ends in \.\w+/;
const skeleton = 'the studio edits one track; the command orispline studio makes a page of one joint of a skeleton';

/** What is said of options within sentences, and what stands there on the page. */
const said: readonly [RegExp, string][] = [
  [/, or `unwrap` if the clock came round/, ''],
  [/; if they are microseconds, set `time_scale` to 1e-6/, '; they may be microseconds'],
  [/(?:; (?:if [^;]*, )?| and )set `\w+`[^;:]*/g, ''],
  [/,? or because `noise` is too small/, ''],
  [/; `normalise` takes the nearest rotation/, ''],
  [/; add `position_tolerance` LENGTH to bound them/, ''],
  [/, and read these with `fps` and `columns` .*/, ', and open these'],
  [/; if another column has the rest of the time, name both, such as t=sec\+nanosec/, '; another column may have the rest of the time'],
];

/** What mends a file, of the options that the library names within a sentence. */
const remedies = ['normalise', 'time_scale'];

/** What the library says, for whoever is at the page. */
export function curedOnPage(message: string): string {
  const text = message.replace(ofSkeletons, (_, format) => (message.includes('glTF is') && format === 'gltf' ? `where it is glTF, ${skeleton}` : skeleton));
  return said.reduce((one, [words, instead]) => one.replace(words, instead), text).replace(/`([a-z]+(?:_[a-z]+)*)`/g, (_, name) => name.replaceAll('_', ' '));
}

/** The word of the library for what would mend a file, where a sentence has it. */
export const remedyIn = (message: string): string | undefined => remedies.find((option) => message.includes(`\`${option}\``));
