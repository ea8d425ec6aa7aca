// SPDX-License-Identifier: Apache-2.0
// The page of a skeleton that moves in two ways.
import { element, menu, place } from '../element';
import { showPlayback } from '../playback';
import { showPlots } from '../plots';
import { clips, type Skeleton } from '../report';
import { canDraw } from '../scene/scenes';
import { choose, subscribe, withClip, type State } from '../state';
import { firstJoint, worstJoint } from './motion';
import { skeletonQuantities } from './quantities';
import { sides, SkeletonScene } from './skeletonScene';
import { clipTable, jointTable } from './tables';

const manyClips = 6; // a table so long stands beside the motion, where there is room
const magnifications = [1, 5, 20, 100];

const places: [State['place'], string][] = [
  ['follow', 'near by'],
  ['path', 'whole path'],
];

const byName = (a: [string, string], b: [string, string]) => a[1].localeCompare(b[1], 'en', { numeric: true });

function menus(skeleton: Skeleton): HTMLElement[] {
  const clipNames = clips.map(({ name }, i): [string, string] => [String(i), name]);
  const jointNames = skeleton.joints.map(({ name }, i): [string, string] => [String(i), name]);
  const [clip, clipSelect] = menu('Clip', clipNames.sort(byName), (i) => choose({ ...withClip(Number(i)), joint: firstJoint(skeleton, clips[Number(i)]) }));
  const [joint, jointSelect] = menu('Joint', jointNames.sort(byName), (i) => choose({ joint: Number(i) }));
  clipSelect.classList.add('first');
  jointSelect.classList.add('second');
  subscribe(['clip', 'joint'], (state) => {
    clipSelect.value = String(state.clip);
    jointSelect.value = String(state.joint);
  });
  return [clip, joint];
}

function controls(scene: SkeletonScene): HTMLElement {
  const from = sides.map(([name, eye]) => element('button', { type: 'button', className: 'side', onclick: () => scene.lookFrom(eye) }, name));
  const [placeChoice, placeSelect] = menu('Seen', places, (where) => choose({ place: where as State['place'] }));
  const [magnifyChoice, magnifySelect] = menu(
    'Differences',
    magnifications.map((factor) => [String(factor), `${factor}×`]),
    (factor) => choose({ magnified: Number(factor) }),
  );
  subscribe(['place', 'magnified'], (state) => {
    placeSelect.value = state.place;
    magnifySelect.value = String(state.magnified);
  });
  return element('div', { className: 'controls' }, element('div', { className: 'choice', attributes: { role: 'group', 'aria-label': 'Seen from' } }, ...from), placeChoice, magnifyChoice);
}

export function showSkeleton(skeleton: Skeleton): void {
  if (clips.length === 0 || skeleton.joints.length === 0) return;
  const [, time] = clips[0].joints[worstJoint(clips[0], 'distance')].distance;
  const isOne = skeleton.joints.length === 1; // a body, of which the path is all that can be seen
  choose({ ...withClip(0, time), joint: firstJoint(skeleton, clips[0]), place: isOne ? 'path' : 'follow' });
  place('measures').parentElement!.classList.add('of-skeleton');
  place('measures').parentElement!.classList.toggle('beside', clips.length >= manyClips);
  place('measures').append(clipTable(skeleton));
  showPlayback(menus(skeleton));
  if (canDraw()) {
    const scene = new SkeletonScene(skeleton);
    place('scenes').append(controls(scene), element('div', { className: 'stages' }, scene.figure));
  }
  showPlots(skeletonQuantities(skeleton), ['clip', 'joint']);
  place('plots').append(jointTable(skeleton));
}
