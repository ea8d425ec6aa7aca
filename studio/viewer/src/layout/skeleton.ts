// SPDX-License-Identifier: Apache-2.0
// A skeleton that moves in two ways, or in one.
import { isAlone, type Skeleton } from '../data/report';
import { playbackOf } from '../controls/playback';
import { element, menu } from '../look/element';
import { firstJoint, worstJoint } from '../motion/poses';
import { plotControls, showPlots, type PlottedOf } from '../plots/plots';
import { skeletonQuantities } from '../quantities/skeleton';
import { withPainter } from '../scene/scenes';
import { sides, SkeletonScene } from '../scene/skeleton/skeletonScene';
import { withClip, type State, type Store } from '../store/store';
import { clipTable, jointTable } from '../tables/skeleton';
import type { Places } from './places';

const manyClips = 6; // a table so long stands beside the motion, where there is room
const magnifications = [1, 5, 20, 100];

const places: [State['place'], string][] = [
  ['follow', 'near by'],
  ['path', 'whole path'],
];

const byName = (a: [string, string], b: [string, string]) => a[1].localeCompare(b[1], 'en', { numeric: true });

function menus({ choose, subscribe }: Store, skeleton: Skeleton): HTMLElement[] {
  const { clips } = skeleton;
  const clipNames = clips.map(({ name }, i): [string, string] => [String(i), name]);
  const jointNames = skeleton.joints.map(({ name }, i): [string, string] => [String(i), name]);
  const [clip, clipSelect] = menu('Clip', clipNames.sort(byName), (i) => choose({ ...withClip(clips, Number(i)), joint: firstJoint(skeleton, clips[Number(i)]) }));
  const [joint, jointSelect] = menu('Joint', jointNames.sort(byName), (i) => choose({ joint: Number(i) }));
  clipSelect.classList.add('first');
  jointSelect.classList.add('second');
  subscribe(['clip', 'joint'], (state) => {
    clipSelect.value = String(state.clip);
    jointSelect.value = String(state.joint);
  });
  return [clip, joint];
}

function controls({ choose, subscribe }: Store, skeleton: Skeleton, scene: SkeletonScene): HTMLElement {
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
  return element('div', { className: 'controls' }, element('div', { className: 'choice', attributes: { role: 'group', 'aria-label': 'Seen from' } }, ...from), placeChoice, ...(isAlone(skeleton) ? [] : [magnifyChoice]));
}

export function showSkeleton(store: Store, skeleton: Skeleton, { main, measures, scenes, plots, playback, keys }: Places): PlottedOf {
  const { clips } = skeleton;
  if (clips.length === 0 || skeleton.joints.length === 0) return () => [];
  const [, time] = clips[0].joints[worstJoint(clips[0], 'distance')].distance;
  const isOne = skeleton.joints.length === 1; // a body, of which the path is all that can be seen
  store.choose({ ...withClip(clips, 0, time), joint: firstJoint(skeleton, clips[0]), place: isOne ? 'path' : 'follow' });
  main.classList.add('of-skeleton');
  main.classList.toggle('beside', clips.length >= manyClips);
  measures.append(clipTable(store, skeleton));
  playback.append(...playbackOf(store, menus(store, skeleton), keys));
  scenes.append(
    ...withPainter(store, (painter) => {
      const scene = new SkeletonScene(store, painter, skeleton);
      return [controls(store, skeleton, scene), element('div', { className: 'stages' }, scene.figure)];
    }),
  );
  plots.append(plotControls(store));
  const plotted = showPlots(store, plots, skeletonQuantities(skeleton), ['clip', 'joint']);
  plots.append(jointTable(store, skeleton));
  return plotted;
}
