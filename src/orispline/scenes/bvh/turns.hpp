// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/math/degrees.hpp>
#include <orispline/scenes/bvh/source.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// Players turn each angle evenly from one frame to the next. So far from the straight way the joint gets.
struct Detour {
  double angle = 0.0;     ///< the largest [rad]
  std::size_t frame = 0;  ///< before it
  /// So many frames for each one keep every detour within `largest_detour`; 1 where they do as they are, 0 where
  /// `most_frames_for_one` do not.
  std::size_t frames_for_one = 1;
};

inline constexpr double largest_detour = 1.0 * radians_per_degree;
inline constexpr std::size_t most_frames_for_one = 64;

/// The turns of a joint over the frames.
struct JointAngles {
  std::vector<double> degrees{};         ///< of each frame, in the order of the turns
  std::vector<std::size_t> near_lock{};  ///< frames within 1° of gimbal lock
  Detour detour{};
};

/// The angles of turns about the axes of these columns, which are rotations: each frame's the nearest to those of the
/// frame before, the first frame's to `start` [°], where there is one.
///
/// Nothing where the turns do not make the rotations: fewer than three, or more, or an axis twice in succession.
[[nodiscard]] std::optional<JointAngles> angles_of(std::span<const Column> columns,
                                                   std::span<const Eigen::Quaterniond> rotations,
                                                   std::span<const double> start);

}}}  // namespace orispline::scenes::bvh
