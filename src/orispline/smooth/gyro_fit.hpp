// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/gyro_rows.hpp>
#include <orispline/smooth/smoothing_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The smooth motion of orientations and of the rates of a gyro.
struct GyroFit {
  GyroFinding finding{};
  StretchProblems problems{};      ///< one
  SmoothingObjective objective{};  ///< with λ
  StretchFits fits{};
  std::vector<std::size_t> places{};                ///< of the orientations among the nodes
  std::vector<std::optional<std::size_t>> rates{};  ///< the row of the gyro that every node is one of, if any
  std::optional<ChosenLambda> chosen{};             ///< absent: τ was stated; without its fits
  double noise = 0.0;                               ///< of the orientations that the weights stand for [rad]
  double interval = 0.0;                            ///< median one between nodes [s]
  double residual_noise = 0.0;                      ///< of the orientations, per axis [rad]
  NodeSigmas sigmas{};  ///< of the nodes, with what the calibration is uncertain by; of counted turns where asked for
};

/// What a fit with a gyro begins with.
struct GyroPlan {
  const Keyframes& recording;
  const GyroRates& gyro;
  const SmoothOptions& options;
  OpenEndedWork& work;
};

/// Whether the rates are sound and stand at times of the recording, with the offset that is stated. Errors: bad_data;
/// bad_argument for an offset as long as the recording.
[[nodiscard]] Expected<void> check_gyro(const GyroPlan& plan);

/// Whether the gyro has to count the turns between orientations, so that nothing is known without it; not where it is
/// undecided how many they are and the orientations may be a motion by themselves.
[[nodiscard]] bool has_to_count_turns(const GyroPlan& plan);

/// The fit where turns are counted. Errors: those of counted_turns(); not_converged; cancelled.
[[nodiscard]] Expected<GyroFit> fit_with_counted_turns(const GyroPlan& plan);

/// From the smooth motion without the gyro: the rates that are wrong are left out, the offset is found, and the whole
/// is fitted; the unbiased risk estimate then says whether the orientations are predicted better with the gyro or
/// without. `noise`: σ of the orientations by that motion [rad]. Errors: those of check_meaning(); bad_data for a gyro
/// that does not overlap the recording; not_converged; cancelled.
[[nodiscard]] Expected<GyroFit> fit_with_gyro(const GyroPlan& plan, const SmoothingSearch& without, double noise);

}}  // namespace orispline
