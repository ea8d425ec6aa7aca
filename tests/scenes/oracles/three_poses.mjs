// SPDX-License-Identifier: Apache-2.0
// Where three.js has the joints of a file in the world: node three_poses.mjs FILE CLIP TIME...
// One line for each joint and time: name, time, px py pz, qw qx qy qz, separated by tabs. FILE is .glb or .bvh.
import { readFileSync } from 'node:fs';
import * as THREE from 'three';

/** A glTF file without what needs a screen to be loaded. */
function bare(bytes) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
  for (const unwanted of ['materials', 'textures', 'images', 'samplers']) delete json[unwanted];
  for (const mesh of json.meshes ?? []) for (const part of mesh.primitives) delete part.material;
  let text = JSON.stringify(json);
  text += ' '.repeat((4 - (Buffer.byteLength(text) % 4)) % 4);
  const head = Buffer.from(bytes.subarray(0, 20)), rest = bytes.subarray(20 + length);
  head.writeUInt32LE(20 + Buffer.byteLength(text) + rest.length, 8);
  head.writeUInt32LE(Buffer.byteLength(text), 12);
  const all = Buffer.concat([head, Buffer.from(text), rest]);
  return all.buffer.slice(all.byteOffset, all.byteOffset + all.length);
}

async function opened(file) {
  const bytes = readFileSync(file);
  if (file.toLowerCase().endsWith('.bvh')) {
    const { BVHLoader } = await import('three/addons/loaders/BVHLoader.js');
    const { skeleton, clip } = new BVHLoader().parse(bytes.toString('utf8'));
    const root = new THREE.Group();
    root.add(skeleton.bones[0]);
    return { root, clips: [clip] };
  }
  globalThis.self ??= globalThis;
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const { scene, animations } = await new GLTFLoader().parseAsync(bare(bytes), '');
  return { root: scene, clips: animations };
}

const [file, name, ...times] = process.argv.slice(2);
const { root, clips } = await opened(file);
const mixer = new THREE.AnimationMixer(root);
const action = mixer.clipAction(clips.length === 1 ? clips[0] : clips.find((clip) => clip.name === name));
action.setLoop(THREE.LoopOnce);
action.clampWhenFinished = true;
action.play();
for (const time of times.map(Number)) {
  mixer.setTime(time);
  root.updateMatrixWorld(true);
  root.traverse((node) => {
    const p = new THREE.Vector3(), q = new THREE.Quaternion(), s = new THREE.Vector3();
    node.matrixWorld.decompose(p, q, s);
    // Loaders replace some letters of names, and keep the file's own here.
    const own = node.userData?.name ?? node.name;
    console.log([own, time, p.x, p.y, p.z, q.w, q.x, q.y, q.z].join('\t'));
  });
}
