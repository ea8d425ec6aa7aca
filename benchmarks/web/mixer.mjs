// SPDX-License-Identifier: Apache-2.0
// A mixer of three.js that moves the joints of a skeleton, by curves of `orispline/lite` and by its own slerp.
import { keysOf } from './keys.mjs';
import { here, ratioOf } from './turns.mjs';

const jointCount = 50, keyCount = 100, frame = 1 / 60; // [s]

const tracksOf = ({ QuaternionKeyframeTrack }) =>
  Array.from({ length: jointCount }, (_, joint) => {
    const { times, orientations } = keysOf(keyCount, joint + 2);
    const turned = orientations.map((_, k) => orientations[k - (k % 4) + [1, 2, 3, 0][k % 4]]);
    return new QuaternionKeyframeTrack(`joint${joint}.quaternion`, times, turned);
  });

const playing = ({ AnimationClip, AnimationMixer, Object3D }, tracks) => {
  const skeleton = new Object3D(), joints = tracks.map((_, k) => Object.assign(new Object3D(), { name: `joint${k}` }));
  skeleton.add(...joints);
  const mixer = new AnimationMixer(skeleton);
  mixer.clipAction(new AnimationClip('moves', -1, tracks)).play();
  return { mixer, joints };
};

/** Ends the run where a joint is not where the curve of `method` takes it. */
const verify = (ori, { mixer, joints }, tracks, method, allowed) => {
  const curves = tracks.map(({ times, values }) => ori.curve(method, { times, orientations: values, order: 'xyzw' }));
  for (let time = 0; time < 40; time += 0.371) {
    mixer.setTime(time);
    joints.forEach(({ name, quaternion }, k) => {
      const wanted = curves[k].at(time), cosine = Math.abs(quaternion.toArray().reduce((sum, x, i) => sum + x * wanted[i], 0));
      if (!(1 - cosine / quaternion.length() <= allowed)) throw new Error(`${name} at ${time} s: found ${quaternion.toArray()}, wanted ${wanted} of ${method}`);
    });
  }
  for (const curve of curves) curve.dispose();
};

/** `THREE`: three.js; `load`: of `orispline/lite`; `animate`: of `orispline/three`. */
export const mixerRatio = async (THREE, load, animate, method = 'auto') => {
  const ori = await load(), plain = playing(THREE, tracksOf(THREE)), exact = playing(THREE, tracksOf(THREE).map((track) => animate(ori, track, method)));
  verify(ori, plain, tracksOf(THREE), 'slerp', 1e-10);
  verify(ori, exact, tracksOf(THREE), method, 1e-14);
  const ratio = await ratioOf(here(() => exact.mixer.update(frame)), here(() => plain.mixer.update(frame)));
  return { what: `a mixer of three.js with ${jointCount} joints, \`${method}\` beside its own slerp`, ratio, most: 1.6 };
};
