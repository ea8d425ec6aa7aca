// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/rational_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The C2 cubic spline of R⁴ through the quaternions of the keys, normalised: one linear system, C2 in time on any
/// knots.
///
/// Symmetric in time, bi-invariant; no sine in a sample. At an end |s| does not change, which makes the rates there
/// those of s itself.
struct Rational {
  static constexpr std::array ends{EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "rational",
                                   .title = "Cubic spline of R⁴, normalised",
                                   .source = "orispline, docs/families/rational.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .support_keys = all_keys,
                                   .ends = ends,
                                   .closes = true};
  /// The least |s| that is taken: there the rounding of doubles has grown a thousandfold.
  static constexpr double least_norm = 1e-3;
  /// Errors: not_converged, with the key before the segment where |s| falls below the least norm.
  [[nodiscard]] static Expected<RationalCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The cubic spline itself.
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
