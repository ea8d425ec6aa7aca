// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/smooth/smoothing_choice.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// σ of every sample per axis [rad], of stretches within which the noise between neighbours is the same and between
/// which it changes by more than a factor of two; empty where it does not. The motion's own bends count as noise here:
/// predicts_better() has the last word.
[[nodiscard]] std::vector<double> changing_noise(const Keyframes& recording);

/// Whether samples are clearly nearer to what all others predict of them under the second search than under the first,
/// by the logarithms of the distances, in which each stretch counts the same whatever its noise is.
struct PredictedSamples {
  const StretchProblems& problems;
  const StretchFits& fits;
  const SmoothingObjective& objective;
};
[[nodiscard]] bool predicts_better(const PredictedSamples& before, const PredictedSamples& after);

}}  // namespace orispline
