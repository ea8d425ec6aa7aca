// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <orispline/curve/keyframe.hpp>

// The published ways to the control orientations of curves through keys, to count their iterations. The library solves
// the same equations by Newton's method.

namespace orispline::cli {

/// The approximation error that the paper states.
inline constexpr double published_tolerance = 1e-6;  // [rad]
inline constexpr std::size_t most_sweeps = 1000;

/// How many sweeps over all control orientations it took, absent where more than `most_sweeps`.
struct Sweeps {
  std::optional<std::size_t> until_near;   ///< until the curve is no farther from any key than the tolerance
  std::optional<std::size_t> until_still;  ///< until no control orientation moves by more than it
};

/// Kim's B-spline with natural ends: every control orientation turns by `share` times what its key is away from the
/// curve.
[[nodiscard]] Sweeps bspline_sweeps(const Keyframes& keys, double share);

/// How the controls of the ends are found.
enum class NuEnds { natural, rest };

/// Nielson's ν-spline with ν = 0: every control orientation is found from its two neighbours.
[[nodiscard]] Sweeps nu_sweeps(const Keyframes& keys, NuEnds ends);

}  // namespace orispline::cli
