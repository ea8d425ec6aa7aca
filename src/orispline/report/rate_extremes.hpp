// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <orispline/report/curve_nodes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// ω [rad/s], α [rad/s²] and jerk [rad/s³] at a place, as exact as plots.
struct PlacedRates {
  CurvePlace place{};
  std::array<Eigen::Vector3f, 3> rates{};

  PlacedRates() = default;
  PlacedRates(const CurvePlace& at, const Motion& motion)
      : place(at),
        rates{motion.angular_velocity.cast<float>(), motion.angular_acceleration.cast<float>(),
              motion.angular_jerk.cast<float>()} {}
};

/// What the rates of a curve are like.
struct RateSurvey {
  MotionScale scale{};
  std::vector<PlacedRates> extremes{};  ///< where they are least and largest in very short stretches of time, rising
};

/// Segments of a curve one after the other.
struct SegmentRun {
  std::size_t first = 0, end = 0;  ///< the last one is the one before `end`
};

[[nodiscard]] RateSurvey survey_of(const PoseCurve& curve, const std::vector<SegmentRun>& runs);

/// Both sides of the knot where the segment begins, if a rate jumps there by more than a thousandth of its largest;
/// else the right one alone.
[[nodiscard]] std::vector<CurveNode> sides_of_knot(std::size_t segment, const NodeSource& source,
                                                   const MotionScale& scale);

/// The nodes, up to `most`, with those extremes among them of which straight lines between the nodes are farther than a
/// 250th of the largest, the farthest first. At knots where a rate jumps as much there are both sides.
[[nodiscard]] std::vector<CurveNode> with_extremes(std::vector<CurveNode> nodes, const NodeSource& source,
                                                   const RateSurvey& survey, std::size_t most);

}}}  // namespace orispline::report
