// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What jumps most where a clip that is repeated goes from its end to its start, over its rotations.
struct ClipSeam {
  struct Step {
    double value = 0.0;
    std::size_t joint = no_parent;  ///< `no_parent` where nothing jumps
  };
  Step pose{};  ///< from the last rotation to the first [rad]
  Step rate{};  ///< of the angular velocity, in the body frame, from that at the end to that at the start [rad/s]
};

/// How a joint may be turned at the end of a loop, beside how it is at the start, in the frame of its parent.
struct JointTurn {
  std::size_t joint = no_parent;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

/// By the interpolation of each channel, from the first key of the clip to its last one.
[[nodiscard]] ORISPLINE_EXPORT ClipSeam seam_of(const Clip& clip, std::span<const JointTurn> turns = {});

}}  // namespace orispline
