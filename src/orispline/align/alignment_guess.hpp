// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/align/alignment_fit.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The rotation that takes vectors to others with the least sum of distances; about an axis that they leave open none.
/// `pull` towards no rotation: a share of all that the vectors say, by which what they say of it by chance is less.
[[nodiscard]] Eigen::Quaterniond rotation_between(std::span<const Eigen::Vector3d> from,
                                                  std::span<const Eigen::Vector3d> to, double pull);

/// Half of the points are not farther from the middle.
[[nodiscard]] double median_distance_from(const Eigen::Vector3d& middle, std::vector<Eigen::Vector3d> points);

/// Successive intervals in the time that two motions have in common, by the clock of the fixed one.
struct Intervals {
  double start, length;
  std::size_t count;
};

/// No shorter than `interval`; none where there are fewer than `least_aligned`.
[[nodiscard]] std::optional<Intervals> common_intervals(Domain moved, Domain fixed, double interval, double offset);

/// What suits an offset of the clocks, near enough for fit_alignment() to begin with: rotations from the turns in equal
/// intervals, then scale and translation from where the middles of the positions lie. A tenth of bad samples does not
/// move it far. `interval` [s]: no shorter than samples of either recording are apart. None where the recordings
/// overlap by fewer than `least_aligned` intervals.
[[nodiscard]] std::optional<Transform> guess_alignment(const AlignmentData& data, const AnyCurve& fixed,
                                                       double interval, double offset);

}}  // namespace orispline
