// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/curve_through.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A curve of positions.
template <class C>
concept Path = CurveThrough<C, Eigen::Vector3d>;

/// The degree of the polynomials in t that a path states its segments to be; 0 where it states none.
template <Path P>
[[nodiscard]] constexpr int degree_of() noexcept {
  if constexpr (requires { P::degree; }) return P::degree;
  else return 0;
}

/// Any path by value: immutable, cheap to copy, evaluation allocates nothing. Outside its knots the end position is
/// held at rest.
class ORISPLINE_EXPORT AnyPath {
 public:
  template <class P>
  requires(!std::same_as<P, AnyPath> && Path<P>) AnyPath(P path)
      : path_(std::move(path)), degree_(degree_of<P>()) {}  // NOLINT: a path is an AnyPath

  /// Position with velocity, acceleration and jerk at time t [s]; at an interior knot of the chosen side.
  [[nodiscard]] LinearMotion linear_motion(double t, Side side = Side::right) const noexcept {
    if (t < knots().front()) return {.position = path_.motion(knots().front(), 0).position};
    if (t > knots().back()) return {.position = path_.motion(knots().back(), knots().segment_at(t)).position};
    return path_.motion(t, knots().segment_at(t, side));
  }

  [[nodiscard]] const Knots& knots() const noexcept { return path_.knots(); }

  /// On one segment, whatever the time: what sampling in bulk falls back on.
  [[nodiscard]] LinearMotion linear_motion_on(std::size_t segment, double t) const noexcept {
    return path_.motion(t, segment);
  }
  [[nodiscard]] Eigen::Vector3d position_on(std::size_t segment, double t) const noexcept {
    return path_.point(t, segment);
  }
  /// The degree of the polynomials in t that all segments are; 0 where they are none.
  [[nodiscard]] int degree() const noexcept { return degree_; }

 private:
  ErasedCurve<Eigen::Vector3d> path_;
  int degree_;
};

/// Any curve through points of one kind.
template <CurvePoint P>
using AnyCurveThrough = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, AnyCurve, AnyPath>;

/// A moving body: its orientation curve and, when the keys carry positions, the path of the same kind.
struct PoseCurve {
  AnyCurve orientation;
  std::optional<AnyPath> position{};
};

}}  // namespace orispline
