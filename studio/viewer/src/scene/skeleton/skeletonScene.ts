// SPDX-License-Identifier: Apache-2.0
// The motions of the skeleton in space, with the joint that is farthest off, and the way of the chosen one.
import { Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import { isAlone, type Clip, type Skeleton } from '../../data/report';
import { element } from '../../look/element';
import { chosen, stepped } from '../../look/number';
import { coloursOf, type Colours } from '../../look/theme';
import { placesAt, placesOf, rigidJoints, roundingsOf, worstAt } from '../../motion/poses';
import type { State, Store } from '../../store/store';
import { Ground } from '../ground';
import { yUp, zUp } from '../overlay';
import type { Painter } from '../painter';
import { release, Stage } from '../stage';
import { Trail } from '../trail';
import { Bones } from './bones';
import { Space } from './space';

export const sides: [string, Vector3][] = [
  ['Front', new Vector3(0.42, -1, 0.28)],
  ['Side', new Vector3(1, -0.05, 0.15)],
  ['Back', new Vector3(-0.42, 1, 0.28)],
  ['Above', new Vector3(0.05, -0.25, 1)],
].map(([name, eye]) => [name as string, (eye as Vector3).normalize()]);

const ring = 0.09; // radius of what marks a joint
const dot = 0.016; // radius of what marks a key
const mostDots = 300; // of a joint: more would hide its way

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
  private readonly ground = new Ground();
  private readonly ways = { before: new Trail({ width: 2, strength: 0.8 }), after: new Trail({ width: 2 }) };
  private dots?: InstancedMesh;

  constructor(
    store: Store,
    painter: Painter,
    private readonly skeleton: Skeleton,
  ) {
    const frame = element('div', { className: 'frame' });
    this.figure = element('figure', { className: 'skeleton' }, this.caption, frame);
    this.stage = new Stage(store, painter, frame, skeleton.up === 'y' ? yUp : zUp);
    const { subscribe } = store;
    subscribe(['clip', 'theme', 'place'], (state) => this.rebuild(state));
    subscribe(['joint', 'magnified'], (state) => this.showWay(state));
    subscribe(['place'], () => this.lookFrom(sides[0][1]));
    subscribe(['clip'], ({ place }) => place === 'path' && this.lookFrom(this.stage.camera.position.clone().normalize()));
    subscribe(['time', 'joint', 'magnified'], (state) => this.showTime(state));
  }

  lookFrom(eye: Vector3): void {
    this.stage.lookAt({ points: this.space.outline, eye });
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
    this.ways.before.object.visible = !isAlone(this.skeleton);
    const content = new Group().add(this.ground.object, this.after.object, this.before.object, this.worst, this.one, this.ways.before.object, this.ways.after.object);
    this.stage.describe(`The skeleton in space, moved by ${this.motions().join(' and ')}: ${this.clip.name}`);
    this.replace(content);
    this.layGround(colours);
    this.showWay(state);
    this.showTime(state);
  }

  /** What they are called; the last one is in colour. */
  private motions(): string[] {
    const { before, after } = this.skeleton;
    return isAlone(this.skeleton) ? [before] : [before, after];
  }

  private replace(content: Group): void {
    const before = this.content;
    this.content = content;
    this.stage.scene.add(content);
    if (!before) return;
    before.removeFromParent();
    release(before);
  }

  /** Below all of the clip. */
  private layGround(colours: Colours): void {
    const { path, floor, unit, square, height } = this.space;
    const reach = path.high.clone().sub(path.low).setZ(0).length() / 2 + 2 * height;
    this.ground.set({ height: floor, square: unit * square, reach });
    this.ground.paint(colours);
    const middle = path.low.clone().add(path.high).multiplyScalar(0.5);
    this.ground.object.position.setX(middle.x).setY(middle.y);
    this.ground.shift(middle);
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
    this.ways.before.set(way(places.before));
    this.ways.after.set(way(after));
    this.ways.before.paint(colours.reference, colours);
    this.ways.after.paint(colours.second, colours);
    if (this.dots) {
      this.dots.removeFromParent();
      release(this.dots);
    }
    this.dots = this.keys(state, colours);
    this.content!.add(this.dots);
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
    this.caption.replaceChildren(
      element('strong', {}, this.clip.name),
      ...this.motions().map((name, i, all) => sign(name, i < all.length - 1 ? colours.reference : colours.first)),
      sign(joints[joint].name, colours.second),
      ...(worst ? [sign(`farthest: ${joints[worst.joint].name} `, colours.mark, element('b', {}, `${stepped(worst.distance, this.clip.errors.distance_step)} ${unit}`))] : []),
      element('span', {}, `squares of ${this.square()}`),
    );
  }
}
