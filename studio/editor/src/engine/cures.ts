// SPDX-License-Identifier: Apache-2.0
// The library's cures are options that the page has not: here they are those of the command.

const studio = 'orispline studio';
const commands = { position_tolerance: 'orispline reduce' } as Readonly<Record<string, string>>;

const nameOf = (option: string): string => `--${(option === 'representation' ? 'input_orientation' : option).replaceAll('_', '-')}`;

/** Such as `--time-scale of orispline studio`. */
const optionOf = (name: string): string => `${nameOf(name)} of ${commands[name] ?? studio}`;

const oneJoint = 'the studio edits one track, so take that of one joint: orispline convert walk.bvh --joint hips -o keys.csv';

/** Files of skeletons, which this module does not read under any name; what else may be in such a file goes on behind it. */
const ofSkeletons = /(?:it|glTF) is read with `input_format` \w+, or without that option under a name that ends in \.(\w+)/;

/** What the library says, for whoever is at the page. `remedy`: the option that would mend it. */
export function curedOnPage(message: string, remedy?: string): string {
  const said = message
    .replace(ofSkeletons, (_, extension) => (extension === 'gltf' ? 'where it is glTF, ' : '') + oneJoint.replace('bvh', extension))
    .replace(/`([a-z]+(?:_[a-z]+)+)`/g, (_, name) => optionOf(name));
  return remedy ? `${said.replace(/\.$/, '')}; ${studio} reads it with ${nameOf(remedy)}` : said;
}
