// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Positions at the times of all stretches [m], and what is to be said of them.
struct SmoothedPositions {
  std::vector<Eigen::Vector3d> positions{};
  PositionSmoothing finding{};
};

/// The positions of a recording, which has some, smoothed as its orientations are, but for themselves. Errors: those of
/// SmoothingSearch::run(), which name them.
[[nodiscard]] Expected<SmoothedPositions> smooth_positions(const Keyframes& recording, const SmoothOptions& options,
                                                           const std::vector<Stretch>& stretches, OpenEndedWork& work);

}}  // namespace orispline
