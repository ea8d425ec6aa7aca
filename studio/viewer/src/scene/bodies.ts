// SPDX-License-Identifier: Apache-2.0
// Bodies of one shape, each part of all of them drawn at once.
import { Group, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion as Turn, Vector3 } from 'three';
import type { Colours } from '../look/theme';
import type { Quaternion } from '../motion/quaternion';
import type { Part } from './shapes';

const middle = new Vector3();

export class Bodies {
  readonly object = new Group();
  private readonly meshes: InstancedMesh[];

  /** `most`: of them. Those that are not solid are seen through. */
  constructor(
    private readonly parts: Part[],
    private readonly most: number,
    isSolid: boolean,
  ) {
    this.meshes = parts.map(({ geometry }) => {
      const mesh = new InstancedMesh(geometry, new MeshLambertMaterial({ transparent: true, depthWrite: isSolid }), most);
      mesh.frustumCulled = false;
      mesh.renderOrder = isSolid ? 1 : 0; // a ghost veils no body
      return mesh;
    });
    for (const mesh of this.meshes) mesh.instanceMatrix = this.meshes[0].instanceMatrix;
    this.object.add(...this.meshes);
  }

  paint(colour: string, colours: Colours, opacity = 1): void {
    this.meshes.forEach(({ material }, i) => {
      const { paint } = this.parts[i];
      const own = material as MeshLambertMaterial;
      if (typeof paint === 'number') own.color.set(colour).multiplyScalar(paint);
      else own.color.set(colours[paint]);
      own.opacity = opacity;
    });
  }

  /** How many of them are drawn. */
  show(count: number): void {
    for (const mesh of this.meshes) mesh.count = Math.min(count, this.most);
  }

  place(i: number, [w, x, y, z]: Quaternion, size: number, position = middle): void {
    this.meshes[0].setMatrixAt(i, new Matrix4().compose(position, new Turn(x, y, z, w), new Vector3(size, size, size)));
    this.meshes[0].instanceMatrix.needsUpdate = true;
  }

  /** Its shape stays. */
  dispose(): void {
    for (const mesh of this.meshes) {
      (mesh.material as MeshLambertMaterial).dispose();
      mesh.dispose();
    }
  }
}
