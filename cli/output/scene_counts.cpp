// SPDX-License-Identifier: Apache-2.0
#include "output/scene_counts.hpp"

#include <algorithm>

#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::cli {

namespace {

std::size_t keys_of(const std::vector<VectorChannel>& channels) {
  std::size_t keys = 0;
  for (const VectorChannel& channel : channels) keys += channel.size();
  return keys;
}

bool is_constant(const RotationChannel& channel) {
  return std::ranges::all_of(channel.values, [&](const Eigen::Quaterniond& value) {
    return value.coeffs() == channel.values.front().coeffs();
  });
}

}  // namespace

void SceneCounts::add(const SceneCounts& other) {
  rotation_tracks += other.rotation_tracks;
  rotation_keys += other.rotation_keys;
  constant_rotation_tracks += other.constant_rotation_tracks;
  translation_tracks += other.translation_tracks;
  translation_keys += other.translation_keys;
  scale_tracks += other.scale_tracks;
  scale_keys += other.scale_keys;
  sign_flips += other.sign_flips;
  if (other.widest_step <= widest_step) return;
  widest_step = other.widest_step;
  widest_step_joint = other.widest_step_joint;
  widest_step_time = other.widest_step_time;
}

SceneCounts counts_of(const Skeleton& skeleton, const Clip& clip) {
  SceneCounts counts{.rotation_tracks = clip.rotations.size(),
                     .translation_tracks = clip.translations.size(),
                     .translation_keys = keys_of(clip.translations),
                     .scale_tracks = clip.scales.size(),
                     .scale_keys = keys_of(clip.scales)};
  for (const RotationChannel& channel : clip.rotations) {
    counts.rotation_keys += channel.size();
    if (is_constant(channel)) ++counts.constant_rotation_tracks;
    for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
      if (channel.values[i].dot(channel.values[i + 1]) < 0.0) ++counts.sign_flips;
      const double step = angular_distance(channel.values[i], channel.values[i + 1]);
      if (step <= counts.widest_step) continue;
      counts.widest_step = step;
      counts.widest_step_joint = skeleton[channel.joint].name;
      counts.widest_step_time = channel.times[i];
    }
  }
  return counts;
}

SceneCounts counts_of(const scenes::Scene& scene) {
  SceneCounts counts;
  for (const Clip& clip : scene.clips) counts.add(counts_of(scene.skeleton, clip));
  return counts;
}

Json json_of(const SceneCounts& counts) {
  Json json{{"rotation_tracks", counts.rotation_tracks},
            {"rotation_keys", counts.rotation_keys},
            {"constant_rotation_tracks", counts.constant_rotation_tracks},
            {"translation_tracks", counts.translation_tracks},
            {"translation_keys", counts.translation_keys},
            {"scale_tracks", counts.scale_tracks},
            {"scale_keys", counts.scale_keys},
            {"sign_flips", counts.sign_flips},
            {"widest_step_deg", counts.widest_step * degrees}};
  if (counts.widest_step == 0.0) return json;
  json["widest_step_joint"] = counts.widest_step_joint;
  json["widest_step_time_s"] = counts.widest_step_time;
  return json;
}

}  // namespace orispline::cli
