// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/curve/path.hpp>
#include <orispline/report/drawn_curve.hpp>
#include <orispline/report/page_numbers.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A time of a curve on one of its segments: at a knot the one that ends there, or the one that begins.
struct CurvePlace {
  double time = 0.0;  ///< [s]
  std::size_t segment = 0;

  [[nodiscard]] friend auto operator<=>(const CurvePlace&, const CurvePlace&) = default;
};

/// The sizes of a motion: what its plots and its path are large compared with.
struct MotionScale {
  std::array<double, 3> rates{};  ///< largest |ω| [rad/s], |α| [rad/s²] and |jerk| [rad/s³]
  double extent = 0.0;            ///< of the path [m]
};

/// A place that a curve is drawn through.
struct CurveNode {
  CurvePlace place{};
  Motion motion{};
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  DrawnSample drawn{};
  bool is_in_gap = false;  ///< nothing is drawn to its neighbours
  std::optional<double>
      error_after{};  ///< [rad], between what is drawn from here to the next node and the curve, if it is known
};

/// A curve with what its nodes are made with.
struct NodeSource {
  const PoseCurve& curve;
  TimeSteps steps;
  HalfFloats halves;
  DrawnWay way = DrawnWay::cubic;

  [[nodiscard]] const Knots& knots() const noexcept { return curve.orientation.knots(); }
  [[nodiscard]] Eigen::Vector3d position(const CurvePlace& place) const {
    const bool ends_there = place.time == knots().times()[std::min(place.segment + 1, knots().segments())];
    return curve.position ? curve.position->linear_motion(place.time, ends_there ? Side::left : Side::right).position
                          : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
  [[nodiscard]] CurveNode node(const CurvePlace& place) const {
    CurveNode node{
        .place = place, .motion = curve.orientation.motion_on(place.segment, place.time), .position = position(place)};
    node.drawn = {steps.rounded(place.time), rounded(node.motion.orientation),
                  halves.rounded(node.motion.angular_velocity)};
    return node;
  }
};

}}}  // namespace orispline::report
