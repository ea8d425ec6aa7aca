// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/scenes/scene_file.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// How much there is in a scene, or in one of its clips.
struct SceneCounts {
  std::size_t rotation_tracks = 0, rotation_keys = 0, constant_rotation_tracks = 0;
  std::size_t translation_tracks = 0, translation_keys = 0;
  std::size_t scale_tracks = 0, scale_keys = 0;
  std::size_t sign_flips = 0;       ///< steps of rotations whose two quaternions have a negative dot product
  double widest_step = 0.0;         ///< of rotations, from key to key [rad]
  std::string widest_step_joint{};  ///< its joint
  double widest_step_time = 0.0;    ///< of the key before it [s]

  /// As much more.
  void add(const SceneCounts& other);
};

[[nodiscard]] SceneCounts counts_of(const Skeleton& skeleton, const Clip& clip);
[[nodiscard]] SceneCounts counts_of(const scenes::Scene& scene);

[[nodiscard]] Json json_of(const SceneCounts& counts);

}  // namespace orispline::cli
