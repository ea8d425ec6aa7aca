// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// The turns of a joint over the frames.
struct JointAngles {
  std::vector<double> degrees{};         ///< of each frame, in the order of the turns
  std::vector<std::size_t> near_lock{};  ///< frames within 1° of gimbal lock
};

/// The angles of turns about these axes of the body (0 x, 1 y, 2 z), each frame's the nearest to those of the frame
/// before, the first frame's to `start` [°], where there is one.
///
/// Nothing where the turns do not make the rotations: fewer than three, or more, or an axis twice in succession.
[[nodiscard]] std::optional<JointAngles> angles_of(std::span<const int> turns,
                                                   std::span<const Eigen::Quaterniond> rotations,
                                                   std::span<const double> start);

}}}  // namespace orispline::scenes::bvh
