// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/curve/curve_through.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A curve of orientations.
template <class C>
concept Curve = CurveThrough<C, Eigen::Quaterniond>;

/// Closed time interval [s] on which a curve is defined.
struct Domain {
  double start, end;
  [[nodiscard]] bool contains(double t) const noexcept { return start <= t && t <= end; }
};

/// Any curve by value: what the registry returns and the bindings hold.
///
/// Immutable, cheap to copy, safe to share between threads. Evaluation allocates nothing. Outside the domain the end
/// orientation is held at rest (ω = 0); `checked_motion` makes that an error instead. A NaN time gives NaN.
class ORISPLINE_EXPORT AnyCurve {
 public:
  template <class C>
  requires(!std::same_as<C, AnyCurve> && Curve<C>) AnyCurve(C curve)
      : curve_(std::move(curve)) {}  // NOLINT: a curve is an AnyCurve

  /// Orientation at time t [s].
  [[nodiscard]] Eigen::Quaterniond operator()(double t) const noexcept {
    t = held(t);
    return curve_.point(t, knots().segment_at(t));
  }

  /// Orientation with body rates at time t [s]. At an interior knot the right-hand segment's, or on request the
  /// left-hand one's; at the last knot always the left-hand one's.
  [[nodiscard]] Motion motion(double t, Side side = Side::right) const noexcept {
    if (t < domain().start || t > domain().end) return {.orientation = (*this)(t)};
    return curve_.motion(t, knots().segment_at(t, side));
  }

  /// As motion(), but a time outside the domain is an error (bad_argument).
  [[nodiscard]] Expected<Motion> checked_motion(double t) const;

  [[nodiscard]] Domain domain() const noexcept { return {knots().front(), knots().back()}; }
  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }

  /// On one segment, whatever the time: what sampling in bulk falls back on.
  [[nodiscard]] Motion motion_on(std::size_t segment, double t) const noexcept { return curve_.motion(t, segment); }
  [[nodiscard]] Eigen::Quaterniond orientation_on(std::size_t segment, double t) const noexcept {
    return curve_.point(t, segment);
  }
  /// What a segment is made of, where it is made of polynomials.
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept { return curve_.form(segment); }

 private:
  [[nodiscard]] double held(double t) const noexcept {
    const Domain d = domain();
    return t < d.start ? d.start : t > d.end ? d.end : t;
  }

  ErasedCurve<Eigen::Quaterniond> curve_;
};

}}  // namespace orispline
