// SPDX-License-Identifier: Apache-2.0
// The motions of the skeleton in space, with the joint that is farthest off, and the way of the chosen one.
import { BufferAttribute, BufferGeometry, Group, InstancedMesh, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import { isAlone, type Clip, type Skeleton } from '../../data/report';
import { element } from '../../look/element';
import { chosen, shown } from '../../look/number';
import { coloursOf, type Colours } from '../../look/theme';
import { placesAt, placesOf, rigidJoints, roundingsOf, worstAt } from '../../motion/poses';
import type { State, Store } from '../../store/store';
import { Stage } from '../stage';
import { Bones } from './bones';
import { Space } from './space';

export const sides: [string, Vector3][] = [
  ['Front', new Vector3(0.42, -1, 0.28)],
  ['Side', new Vector3(1, -0.05, 0.15)],
  ['Back', new Vector3(-0.42, 1, 0.28)],
  ['Above', new Vector3(0.05, -0.25, 1)],
].map(([name, eye]) => [name as string, (eye as Vector3).normalize()]);

const ring = 0.09; // radius of what marks a joint
const dot = 0.022; // likewise of a key
const mostDots = 300; // of a joint: more would hide its way
const mostLines = 120; // of the floor

function grid({ path, floor, unit, square, height }: Space, colour: string): LineSegments {
  const points: Vector3[] = [];
  const margin = 0.5 * height;
  const [width, depth] = [path.high.x - path.low.x + 2 * margin, path.high.y - path.low.y + 2 * margin];
  const step = unit * square * Math.ceil(Math.max(width, depth) / (unit * square * mostLines));
  const range = (low: number, high: number) => [Math.floor((low - margin) / step), Math.ceil((high + margin) / step)];
  const [west, east] = range(path.low.x, path.high.x);
  const [south, north] = range(path.low.y, path.high.y);
  for (let i = west; i <= east; ++i) points.push(new Vector3(i * step, south * step, floor), new Vector3(i * step, north * step, floor));
  for (let i = south; i <= north; ++i) points.push(new Vector3(west * step, i * step, floor), new Vector3(east * step, i * step, floor));
  return new LineSegments(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({ color: colour }));
}

/** Seen through all that is before it. */
function mark(colour: string, radius: number, opacity: number): Mesh {
  const made = new Mesh(new SphereGeometry(radius, 24, 16), new MeshBasicMaterial({ color: colour, transparent: true, opacity, depthTest: false, depthWrite: false }));
  made.renderOrder = 1;
  return made;
}

const placeOf = (places: ArrayLike<number>, joint: number) => new Vector3(places[3 * joint], places[3 * joint + 1], places[3 * joint + 2]);

export class SkeletonScene {
  readonly figure: HTMLElement;
  private readonly caption = element('figcaption');
  private readonly stage: Stage;
  private space!: Space;
  private clip!: Clip;
  private content?: Group;
  private before!: Bones;
  private after!: Bones;
  private worst!: Mesh;
  private one!: Mesh;
  private way = new Group();

  constructor(
    store: Store,
    private readonly skeleton: Skeleton,
  ) {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: 'skeleton' }, this.caption, frame);
    this.stage = new Stage(store, frame);
    const { subscribe } = store;
    subscribe(['clip', 'theme', 'place'], (state) => this.rebuild(state));
    subscribe(['joint', 'magnified'], (state) => this.showWay(state));
    subscribe(['place'], () => this.lookFrom(sides[0][1]));
    subscribe(['clip'], ({ place }) => place === 'path' && this.lookFrom(this.stage.camera.position.clone().normalize()));
    subscribe(['time', 'joint', 'magnified'], (state) => this.showTime(state));
  }

  lookFrom(eye: Vector3): void {
    this.stage.lookAt(this.space.outline, eye);
  }

  private rebuild(state: State): void {
    const colours = coloursOf(state);
    this.clip = this.skeleton.clips[state.clip];
    this.space = new Space(this.skeleton, this.clip, state.place === 'path');
    const { joints } = this.skeleton;
    const rigid = rigidJoints(this.clip, joints, this.space.height / this.space.unit);
    this.before = new Bones(joints, rigid, () => true, { colour: colours.reference, opacity: 0.35 }, 1.4);
    this.after = new Bones(joints, rigid, ({ is_compared }) => is_compared, { colour: colours.first, opacity: 1 });
    this.worst = mark(colours.mark, ring, 0.4);
    this.one = mark(colours.second, 0.45 * ring, 0.9);
    this.before.object.visible = !isAlone(this.skeleton);
    const content = new Group().add(grid(this.space, colours.grid), this.after.object, this.before.object, this.worst, this.one);
    this.stage.describe(`The skeleton in space, moved by ${this.motions().join(' and ')}: ${this.clip.name}`);
    this.stage.replace(this.content, content);
    this.content = content;
    this.way = new Group();
    content.add(this.way);
    this.showWay(state);
    this.showTime(state);
  }

  /** What they are called; the last one is in colour. */
  private motions(): string[] {
    const { before, after } = this.skeleton;
    return isAlone(this.skeleton) ? [before] : [before, after];
  }

  /** After, with what differs magnified. */
  private magnified(before: Float32Array, after: Float32Array, { magnified }: State): Float32Array {
    return magnified === 1 ? after : after.map((value, i) => before[i] + magnified * (value - before[i]));
  }

  private showWay(state: State): void {
    const colours = coloursOf(state);
    const width = 3 * this.skeleton.joints.length;
    const places = placesOf(this.clip);
    const after = this.magnified(places.before, places.after, state);
    const way = (all: Float32Array) => this.space.shown(Float32Array.from({ length: (3 * all.length) / width }, (_, i) => all[Math.floor(i / 3) * width + 3 * state.joint + (i % 3)]));
    const line = (points: Float32Array, colour: string) => new Line(new BufferGeometry().setAttribute('position', new BufferAttribute(points, 3)), new LineBasicMaterial({ color: colour }));
    this.content!.remove(this.way);
    this.way = new Group().add(line(way(after), colours.second), this.keys(state, colours));
    if (!isAlone(this.skeleton)) this.way.add(line(way(places.before), colours.reference));
    this.content!.add(this.way);
  }

  /** The keys of the chosen joint, on its way. */
  private keys(state: State, colours: Colours): InstancedMesh {
    const { key_t } = this.clip.joints[state.joint];
    const times = key_t.length > mostDots ? key_t.subarray(0, 0) : key_t;
    const dots = new InstancedMesh(new SphereGeometry(dot, 10, 8), new MeshBasicMaterial({ color: colours.second }), times.length);
    times.forEach((time, i) => dots.setMatrixAt(i, new Matrix4().setPosition(placeOf(this.placesAt(time, state).after, state.joint))));
    dots.frustumCulled = false;
    return dots;
  }

  private placesAt(time: number, state: State) {
    const [before, after] = [placesAt(this.clip, 'before', time), placesAt(this.clip, 'after', time)];
    return { before: this.space.shown(before), after: this.space.shown(this.magnified(before, after, state)) };
  }

  private showTime(state: State): void {
    const { before, after } = this.placesAt(state.time, state);
    this.before.move(before);
    this.after.move(after);
    const worst = isAlone(this.skeleton) ? null : worstAt(this.clip, state.time, roundingsOf(this.skeleton).distance);
    this.worst.visible = worst !== null;
    if (worst) this.worst.position.copy(placeOf(after, worst.joint));
    this.one.position.copy(placeOf(after, state.joint));
    this.content!.position.copy(this.space.origin(before, state.place === 'path'));
    this.showCaption(worst, coloursOf(state), state);
    this.stage.draw();
  }

  /** The length of a square of the floor. */
  private square(): string {
    const { unit } = this.skeleton;
    const { square } = this.space;
    return unit === 'mm' && square >= 1000 ? `${chosen(square / 1000)} m` : `${chosen(square)} ${unit}`;
  }

  private showCaption(worst: ReturnType<typeof worstAt>, colours: Colours, { joint }: State): void {
    const { unit, joints } = this.skeleton;
    const sign = (text: string, colour: string, ...more: (Node | string)[]) => {
      const swatch = element('i');
      swatch.style.background = colour;
      return element('span', {}, swatch, text, ...more);
    };
    const length = (text: string) => (unit ? `${text} ${unit}` : text);
    this.caption.replaceChildren(
      element('strong', {}, this.clip.name),
      ...this.motions().map((name, i, all) => sign(name, i < all.length - 1 ? colours.reference : colours.first)),
      sign(joints[joint].name, colours.second),
      ...(worst ? [sign(`farthest: ${joints[worst.joint].name} `, colours.mark, element('b', {}, length(shown(worst.distance))))] : []),
      element('span', {}, `squares of ${this.square()}`),
    );
  }
}
