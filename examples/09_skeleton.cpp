// SPDX-License-Identifier: Apache-2.0
// A skeleton from nothing to a file: an arm of two bones waves, its clip is reduced to the fewest keys that keep every
// point of it within 2 mm, and written as glTF.

#include <cmath>
#include <cstdio>
#include <orispline/reduce.hpp>
#include <orispline/rotations.hpp>
#include <orispline/scenes.hpp>
#include <vector>

/// Shoulder, elbow and hand; bones of 30 cm and 25 cm along x.
orispline::Expected<orispline::Skeleton> arm() {
  using Eigen::Vector3d;
  return orispline::Skeleton::make({{.name = "shoulder", .rest = {.translation = Vector3d(0.0, 1.4, 0.0)}},
                                    {.name = "elbow", .parent = 0, .rest = {.translation = Vector3d(0.30, 0.0, 0.0)}},
                                    {.name = "hand", .parent = 1, .rest = {.translation = Vector3d(0.25, 0.0, 0.0)}}});
}

/// Four seconds at 30 Hz, as programs of animation bake them: a key per frame of every joint.
orispline::Clip wave() {
  orispline::RotationChannel shoulder{.joint = 0}, elbow{.joint = 1};
  for (int frame = 0; frame <= 120; ++frame) {
    const double t = frame / 30.0;
    const Eigen::Vector3d raised(0.3 * std::sin(1.5 * t), 0.2 * std::sin(t), 0.8 + 0.3 * std::sin(1.5 * t));
    const Eigen::Vector3d bent(0.0, 0.0, 0.7 + 0.6 * std::sin(4.0 * t));
    shoulder.times.push_back(t);
    shoulder.values.push_back(orispline::exp<double>(raised));
    elbow.times.push_back(t);
    elbow.values.push_back(orispline::exp<double>(bent));
  }
  return {.name = "wave", .rotations = {shoulder, elbow}};
}

/// Reduces the clips, writes them to a file, and says what became of the keys.
orispline::Expected<void> reduce_to(const orispline::scenes::Scene& scene, const char* path) {
  // Angles follow from the length: a joint may turn by so much that what hangs on it stays within 2 mm.
  const auto reduced = orispline::reduce_clips(
      scene.skeleton, scene.clips, {.world_tolerance = 0.002, .precision = orispline::KeyPrecision::float32});
  if (!reduced) return tl::unexpected(reduced.error());
  orispline::scenes::Scene small = scene;
  small.clips.clear();
  for (const orispline::ClipReduction& reduction : *reduced) {
    small.clips.push_back(reduction.clip);
    std::printf("%s: %zu of %zu keys, within 2 mm: %s\n", reduction.clip.name.c_str(), reduction.rotation_keys,
                reduction.rotation_keys_before, reduction.distance.largest.value <= 0.002 ? "yes" : "no");
  }
  const auto warnings = orispline::scenes::write_scene(small, path);
  return warnings ? orispline::Expected<void>() : tl::unexpected(warnings.error());
}

int main() {
  const auto skeleton = arm();
  if (!skeleton) return std::fprintf(stderr, "%s\n", describe(skeleton.error()).c_str()), 1;
  const orispline::scenes::Scene scene{.name = "arm", .skeleton = *skeleton, .clips = {wave()}};
  if (const auto done = reduce_to(scene, "arm.glb"); !done)
    return std::fprintf(stderr, "%s\n", describe(done.error()).c_str()), 1;

  // What a viewer finds in the file, beside the motion that it was made from.
  const auto read = orispline::scenes::read_scene("arm.glb");
  if (!read) return std::fprintf(stderr, "%s\n", describe(read.error()).c_str()), 1;
  const orispline::ClipMotion before(scene.skeleton, scene.clips[0]), after(read->skeleton, read->clips[0]);
  const auto same = counterparts_of(scene.skeleton, read->skeleton);
  const auto found = differences(before, after, same.joints, key_times(scene.clips[0]));
  for (std::size_t i = 0; i < found.size(); ++i)
    std::printf("%-8s within %.0f mm\n", scene.skeleton[i].name.c_str(), std::ceil(1e3 * found[i].distance.value));

  // A joint is a curve like any other, with exact rates.
  const std::size_t hand = *read->skeleton.find("hand");
  const auto curve = joint_curve(read->skeleton, read->clips[0], hand, orispline::JointSpace::world);
  if (!curve) return std::fprintf(stderr, "%s\n", describe(curve.error()).c_str()), 1;
  std::printf("hand at 1 s: %.2f m high, %.1f m/s fast\n", curve->position->linear_motion(1.0).position.y(),
              curve->position->linear_motion(1.0).velocity.norm());
}
