// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/smooth/gyro_alignment.hpp>
#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The nodes of a fit with a gyro: the times of the orientations, those of the rates, and some between two of them
/// where the body turns too far for one step of a curve.
struct GyroRows {
  SmoothingProblem problem{};         ///< with the weights of orientations and rates
  SmoothedNodes start{};              ///< orientations that the rates lead through the recorded ones, and their rates
  std::vector<std::size_t> places{};  ///< of the orientations among the nodes
  std::vector<std::optional<std::size_t>> rates{};  ///< the row of the gyro that every node is one of, if any
  std::vector<bool> unled{};                        ///< intervals between nodes about which the gyro says nothing
};

/// Whether the rates turn so far between orientations, between more than a tenth of them, that they have to count the
/// turns.
[[nodiscard]] bool counts_turns(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts);

/// The correction under which the rates, integrated, lead from each orientation to the next one, and σ of these steps
/// [rad]. Error (bad_data): it cannot be told how often the body turned between two of them.
struct TurnCount {
  Eigen::Vector3d correction;
  double noise;
};
[[nodiscard]] Expected<TurnCount> counted_turns(const SeenPoses& poses, const GyroRates& gyro,
                                                const CountedRates& counts, double offset);

/// `poses.fitted` leads the start where there is one. σ of the orientations is `poses.noise`.
[[nodiscard]] GyroRows rows_of(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                               double gyro_noise, const GyroAlignment& alignment);

}}  // namespace orispline
