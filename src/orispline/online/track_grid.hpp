// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/batch/sample_grid.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which samples a track has: those of steps that lie between its keys, or those of a request.
struct TrackGrid {
  double step = 0.01;             ///< [s], greater than 0: sample k at k * step / parts + start
  double parts = 1.0;             ///< samples in a step, greater than 0
  std::optional<double> start{};  ///< [s]; absent: where the first curve begins
  /// Instead of both the grid of a rate or a count, where it is absent from the start of the first curve to the end of
  /// the last: all of its samples, which before the one and after the other hold the end orientation at rest.
  std::optional<SampleGrid::Request> request{};
};

}}  // namespace orispline
