// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_choice.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What can be read off a recording before anything is fitted.
struct RecordingScale {
  double interval = 0.0;  ///< median one [s]
  double noise = 0.0;     ///< local_noise() [rad], at least `least_noise`
};

[[nodiscard]] RecordingScale scale_of(const Keyframes& recording);

/// The recording cut at its gaps; stretches with too few samples for the penalty are left out. Errors: bad_argument for
/// a gap not longer than the median interval; bad_data where no stretch is left.
[[nodiscard]] Expected<std::vector<Stretch>> stretches_of(const Keyframes& recording, Penalty penalty,
                                                          std::optional<double> gap);

/// The problems of the stretches, without a gyro. `noise`: σ of a usual sample [rad]; `shares`: of the weights of all
/// samples over that of such a one, or empty.
[[nodiscard]] StretchProblems problems_of(const Keyframes& recording, const std::vector<Stretch>& stretches,
                                          double noise, const std::vector<double>& shares = {});

/// Those of its positions, seen from `origin` in that unit [m], which is σ.
[[nodiscard]] StretchProblems position_problems_of(const Keyframes& recording, const std::vector<Stretch>& stretches,
                                                   const Eigen::Vector3d& origin, double unit);

/// Samples that are farther away than a limit.
struct FarSamples {
  std::vector<std::size_t> single{};   ///< indices into the recording
  std::vector<std::size_t> in_runs{};  ///< of which three or more follow each other, or that are needed
};

/// Those whose lengths, of any kind, are beyond the limit, those of each stretch by themselves.
[[nodiscard]] FarSamples far_samples(const std::vector<std::vector<double>>& lengths,
                                     const std::vector<Stretch>& stretches, double limit);

/// Every sample has its weight again, a usual one that of this σ.
void readmit(StretchProblems& problems, double noise);

/// Takes the weight of the single samples, and gives them back, but for stretches that would keep too few: theirs are
/// added to those in runs. Error (bad_data): the only stretch would keep too few.
[[nodiscard]] Expected<FarSamples> reject(StretchProblems& problems, const std::vector<Stretch>& stretches,
                                          FarSamples far, Penalty penalty);

}}  // namespace orispline
