// SPDX-License-Identifier: Apache-2.0
// The clips, and the joints of the one that is shown: a click on a row shows it, a click on a time leads there.
import { isAlone, type Clip, type KeyCounts, type Largest, type Skeleton } from '../data/report';
import { breakable, element } from '../look/element';
import { stepped } from '../look/number';
import { sortable, type Head } from '../look/sortable';
import { firstJoint, roundingsOf, stepOf, worstJoint, type Kind } from '../motion/poses';
import { withClip, type Store } from '../store/store';

const cell = (text: string | Node) => element('td', { className: 'number' }, text);

/** A way to where something is largest. */
function wayTo(text: string, where: string, go: () => void): HTMLButtonElement {
  const onclick = (event: MouseEvent) => {
    event.stopPropagation();
    go();
  };
  return element('button', { type: 'button', className: 'moment', title: `Go there: ${where}`, onclick }, text);
}

const ofOne = {
  distance: 'Largest shell distance: of points that go with a joint from where they are when the clip begins, in the world',
  angle: 'Largest angle of the rotation from where the clip begins, in the frame of the parent',
};
const ofBoth = {
  distance: 'Largest shell distance: between the same points of both motions in the world',
  angle: 'Largest angle between both rotations, in the frame of the parent',
};

const errorHeads = (unit: string, { distance, angle }: typeof ofBoth): Head[] => [
  { id: 'distance', label: 'Distance', unit, explanation: distance, isNumber: true, fromLargest: true },
  { id: 'distance_at', label: 'at', explanation: 'Where the shell distance is largest', isNumber: true },
  { id: 'angle_deg', label: 'Angle', unit: 'deg', explanation: angle, isNumber: true, fromLargest: true },
  { id: 'angle_at', label: 'at', explanation: 'Where the angle is largest', isNumber: true },
];

const keyHeads = (skeleton: Skeleton, what: string): Head[] => [
  { id: 'before', label: 'Keys', explanation: `Keys of ${what} in ${skeleton.before}`, isNumber: true, fromLargest: true },
  ...(isAlone(skeleton) ? [] : [{ id: 'after', label: 'after', explanation: `The same in ${skeleton.after}`, isNumber: true, fromLargest: true }]),
];

const headsOf = (skeleton: Skeleton, what: string) => [...keyHeads(skeleton, what), ...errorHeads(skeleton.unit, isAlone(skeleton) ? ofOne : ofBoth)];

const keyCells = (skeleton: Skeleton, keys: KeyCounts) => keys.slice(0, isAlone(skeleton) ? 1 : 2).map((count) => cell(String(count)));

export function clipTable({ choose, subscribe, moments }: Store, skeleton: Skeleton): HTMLTableElement {
  const { clips } = skeleton;
  const roundings = roundingsOf(skeleton);
  const largest = (clip: Clip, kind: Kind) => clip.joints[worstJoint(clip, kind)][kind];
  const show = (index: number, joint = firstJoint(skeleton, clips[index]), time?: number) => choose({ ...withClip(clips, index, time), joint });
  const place = (clip: Clip, kind: Kind) => {
    const joint = worstJoint(clip, kind);
    const { name } = skeleton.joints[joint];
    const [value, time] = clip.joints[joint][kind];
    if (value <= roundings[kind]) return cell('–');
    return cell(wayTo(`${name}, ${moments.text(time)}`, clip.name, () => show(clips.indexOf(clip), joint, time)));
  };
  const lineOf = (clip: Clip) => {
    const line = element(
      'tr',
      { onclick: () => show(clips.indexOf(clip)), attributes: { 'data-clip': clip.name } },
      element('th', { scope: 'row', title: clip.name }, ...breakable(clip.name)),
      ...keyCells(skeleton, clip.rotation_keys),
    );
    for (const kind of ['distance', 'angle_deg'] as const) line.append(cell(stepped(largest(clip, kind)[0], stepOf(clip.errors, kind), roundings[kind])), place(clip, kind));
    line.append(cell(moments.text(clip.end - clip.start)));
    return line;
  };
  const valueOf = (clip: Clip, id: string) => {
    if (id === 'name') return clip.name;
    if (id === 'duration') return clip.end - clip.start;
    if (id === 'before' || id === 'after') return clip.rotation_keys[id === 'before' ? 0 : 1];
    const kind = id.startsWith('angle') ? 'angle_deg' : 'distance';
    return id.endsWith('_at') ? skeleton.joints[worstJoint(clip, kind)].name : largest(clip, kind)[0];
  };
  const heads = [
    { id: 'name', label: 'Clip' },
    ...headsOf(skeleton, 'rotations, of tracks of three keys and more,'),
    { id: 'duration', label: 'Duration', isNumber: true },
  ];
  const { table, lines, sort } = sortable(heads, clips, { lineOf, valueOf });
  if (!isAlone(skeleton)) sort('distance');
  subscribe(['clip'], (state) => {
    for (const [clip, line] of lines) line.classList.toggle('is-first', clip === clips[state.clip]);
  });
  return table;
}

interface JointLine {
  joint: number;
  name: string;
}

/** Of the clip that is shown: those joints that both motions have. */
function jointLines({ choose, moveTo, moments }: Store, skeleton: Skeleton, clip: Clip) {
  const roundings = roundingsOf(skeleton);
  const valueOf = ({ joint, name }: JointLine, id: string) => {
    const { keys, ...largest } = clip.joints[joint];
    if (id === 'name') return name;
    if (id === 'before' || id === 'after') return keys[id === 'before' ? 0 : 1];
    return id.endsWith('_at') ? largest[id === 'angle_at' ? 'angle_deg' : 'distance'][1] : largest[id as Kind][0];
  };
  const go = (joint: number, time: number) => () => {
    choose({ joint });
    moveTo(time);
  };
  const cellsOf = ([value, time]: Largest, kind: Kind, { joint, name }: JointLine) => [
    cell(stepped(value, stepOf(clip.errors, kind), roundings[kind])),
    cell(value > roundings[kind] ? wayTo(moments.text(time), name, go(joint, time)) : '–'),
  ];
  const lineOf = (row: JointLine) => {
    const { keys, angle_deg, distance } = clip.joints[row.joint];
    return element(
      'tr',
      { onclick: () => choose({ joint: row.joint }), attributes: { 'data-joint': row.name } },
      element('th', { scope: 'row', title: row.name }, ...breakable(row.name)),
      ...keyCells(skeleton, keys),
      ...cellsOf(distance, 'distance', row),
      ...cellsOf(angle_deg, 'angle_deg', row),
    );
  };
  const rows = skeleton.joints.flatMap(({ name, is_compared }, joint) => (is_compared ? [{ joint, name }] : []));
  const made = sortable([{ id: 'name', label: 'Joint' }, ...headsOf(skeleton, 'its rotation')], rows, { lineOf, valueOf });
  if (!isAlone(skeleton)) made.sort('distance');
  return made;
}

export function jointTable(store: Store, skeleton: Skeleton): HTMLElement {
  const { current, subscribe } = store;
  const { clips } = skeleton;
  const frame = element('div', { className: 'rows' });
  const name = element('strong');
  let lines = new Map<JointLine, HTMLTableRowElement>();
  const mark = () => {
    for (const [{ joint }, line] of lines) line.classList.toggle('is-second', joint === current().joint);
  };
  subscribe(['clip'], ({ clip }) => {
    const made = jointLines(store, skeleton, clips[clip]);
    name.textContent = `Joints of ${clips[clip].name}`;
    lines = made.lines;
    frame.replaceChildren(made.table);
    mark();
  });
  subscribe(['joint'], mark);
  return element('figure', { className: 'joints' }, element('figcaption', {}, name), frame);
}
