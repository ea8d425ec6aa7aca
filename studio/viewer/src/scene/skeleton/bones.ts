// SPDX-License-Identifier: Apache-2.0
// A skeleton as bones from joint to joint, thick near the parent. Where a joint changes its distance from the parent there
// is no bone: a thin line joins them.
import { Group, InstancedMesh, LatheGeometry, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry, Vector2, Vector3 } from 'three';
import type { Joint } from '../../data/report';

interface Look {
  colour: string;
  opacity: number;
}

const thickness = 0.1; // of the length of a bone
const thickest = 0.035; // lengths of the scene
const thin = 0.004; // the same of what is no bone
const ball = 0.8; // radius of a joint, of the thickness

/** From 0 to 1 along y. */
const bone = () => new LatheGeometry([new Vector2(0, 0), new Vector2(1, 0.16), new Vector2(0.12, 1), new Vector2(0, 1)], 6);

const upwards = new Vector3(0, 1, 0);

export class Bones {
  readonly object = new Group();
  private readonly bones: InstancedMesh;
  private readonly balls: InstancedMesh;

  /** `isRigid`: of each joint, whether it stays in its distance from the parent. */
  constructor(
    private readonly joints: Joint[],
    private readonly isRigid: boolean[],
    private readonly isDrawn: (joint: Joint) => boolean,
    { colour, opacity }: Look,
    private readonly swelling = 1,
  ) {
    const solid = opacity === 1;
    const material = new MeshLambertMaterial({ color: colour, flatShading: true, transparent: !solid, opacity, depthWrite: solid });
    this.bones = new InstancedMesh(bone(), material, joints.length);
    this.balls = new InstancedMesh(new SphereGeometry(1, 12, 8), material, joints.length);
    for (const mesh of [this.bones, this.balls]) {
      mesh.frustumCulled = false;
      this.object.add(mesh);
    }
  }

  /** x, y, z of every joint. */
  move(places: ArrayLike<number>): void {
    const at = (joint: number) => new Vector3(places[3 * joint], places[3 * joint + 1], places[3 * joint + 2]);
    const none = new Matrix4().makeScale(0, 0, 0);
    this.joints.forEach((joint, i) => {
      const isBone = this.isDrawn(joint) && joint.parent !== null;
      const from = isBone ? at(joint.parent!) : at(i);
      const along = at(i).sub(from);
      const length = along.length();
      const radius = this.isRigid[i] ? this.swelling * Math.min(thickness * length, thickest) : thin;
      const turn = new Quaternion().setFromUnitVectors(upwards, length > 0 ? along.clone().divideScalar(length) : upwards);
      this.bones.setMatrixAt(i, isBone && length > 0 ? new Matrix4().compose(from, turn, new Vector3(radius, length, radius)) : none);
      const size = this.swelling * ball * Math.min(Math.max(thickness * length, 0.3 * thickest), 0.55 * thickest);
      this.balls.setMatrixAt(i, this.isDrawn(joint) ? new Matrix4().makeScale(size, size, size).setPosition(at(i)) : none);
    });
    this.bones.instanceMatrix.needsUpdate = true;
    this.balls.instanceMatrix.needsUpdate = true;
  }
}
