// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <orispline/analysis/segment_hull.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a part of a segment is looked at: so many steps, and the times at their ends.
inline constexpr std::size_t steps_of_part = 16, times_of_part = steps_of_part + 1;

/// |ω|, |α| and the size of the torque, or what these reach.
using RateSizes = std::array<double, 3>;

/// The square of a rate's length, and half its derivative.
struct RateHeight {
  double square = 0.0, slope = 0.0;
};

/// The three rates at a time [s], and the jerk |dα/dt|².
struct RateSample {
  double time = 0.0;
  std::array<RateHeight, 3> heights{};
  double jerk_square = 0.0;
};
using RateSamples = std::array<RateSample, times_of_part>;

/// What the rates reach between two samples, and how far an estimate of |ω|² is off, of the largest of the part; 0 for
/// bounds.
struct StepReach {
  RateSizes sizes{};
  double unresolved = 0.0;
  double turn = 0.0;  ///< of the body on the step [rad]; 0 for bounds
};

/// What the rates reach on the steps between samples: bounds that hold where the segment is stated as polynomials, else
/// an estimate.
///
/// On a step of half length r a vector is nowhere longer than at the longer of its ends and r²/2 times the bound of its
/// second derivative. The estimate is the largest value of the cubic that has the squares and slopes at the ends of the
/// step, and how far such cubics over two steps are from what is found in their middle: sixteen times the error of the
/// one over one step, where the rate is smooth.
class RateReach {
 public:
  /// Of a form and its duration [s]. Refers to `moments`.
  RateReach(const SegmentForm& form, const KnotSpan& span, const MomentBounds& moments);

  [[nodiscard]] bool is_bound() const noexcept { return coarse_.has_value(); }
  /// On each step of a part, after refine().
  [[nodiscard]] std::array<StepReach, steps_of_part> of_steps(const RateSamples& samples) const;
  /// On all steps of the segment: for bounds in one, which costs less and may be more.
  [[nodiscard]] StepReach of_segment(const RateSamples& samples) const;
  /// Makes the bounds of steps, which cost more.
  void refine();
  /// What there is of rounding in the bounds; no shorter part has less.
  [[nodiscard]] const RateSizes& rounding() const noexcept { return rounding_; }

 private:
  [[nodiscard]] RateSizes bounds(const RateSizes& squares, double jerk_square, double step,
                                 const HullBounds& hull) const;

  const SegmentForm& form_;
  KnotSpan span_;
  const MomentBounds& moments_;
  std::optional<CoarseBounds> coarse_;
  std::optional<SegmentHull> hull_{};
  RateSizes rounding_{};

  void round(double rate, const HullBounds& off) {
    rounding_ = {off.rate, off.acceleration, moments_.rounding(rate, off.rate, off.acceleration)};
  }
};

}}  // namespace orispline
