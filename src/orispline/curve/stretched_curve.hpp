// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <orispline/curve/path.hpp>
#include <orispline/curve/taylor.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Curves one after the other, one at least, with gaps between them, where points are NaN. A gap is a segment of which
/// the ends belong to the curves beside it; where the motion jumps it has no length, and its time belongs to the next
/// curve.
template <CurvePoint P>
class StretchedCurve {
 public:
  explicit StretchedCurve(std::vector<AnyCurveThrough<P>> stretches)
      : stretches_(std::move(stretches)), knots_(knots_of(stretches_)) {
    for (std::uint32_t i = 0; i < stretches_.size(); ++i) {
      const auto segments = static_cast<std::uint32_t>(stretches_[i].knots().segments());
      for (std::uint32_t segment = 0; segment < segments; ++segment) places_.push_back({i, segment, false});
      if (i + 1 < stretches_.size()) places_.push_back({i, segments == 0 ? 0 : segments - 1, true});
    }
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept {
    return on(t, segment, [](const auto& curve, double time, std::size_t own) { return point_on(curve, time, own); });
  }
  [[nodiscard]] MotionOf<P> motion(double t, std::size_t segment) const noexcept {
    return on(t, segment, [](const auto& curve, double time, std::size_t own) { return motion_on(curve, time, own); });
  }
  [[nodiscard]] PointOver<P, Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    return taylor(motion(t.c[0], segment), t - t.c[0]);
  }
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept requires std::same_as<P, Eigen::Quaterniond> {
    const Place& place = places_[segment];
    return place.is_gap ? SegmentForm() : stretches_[place.stretch].form(place.segment);
  }

 private:
  struct Place {
    std::uint32_t stretch, segment;  // of a gap those before it
    bool is_gap;
  };

  [[nodiscard]] static Knots knots_of(const std::vector<AnyCurveThrough<P>>& stretches) {
    std::vector<double> times;
    for (const auto& stretch : stretches) {
      const auto own = stretch.knots().times();
      times.insert(times.end(), own.begin(), own.end());
    }
    return Knots(std::move(times));
  }

  [[nodiscard]] static P point_on(const AnyCurve& curve, double t, std::size_t segment) noexcept {
    return curve.orientation_on(segment, t);
  }
  [[nodiscard]] static P point_on(const AnyPath& path, double t, std::size_t segment) noexcept {
    return path.position_on(segment, t);
  }
  [[nodiscard]] static Motion motion_on(const AnyCurve& curve, double t, std::size_t segment) noexcept {
    return curve.motion_on(segment, t);
  }
  [[nodiscard]] static LinearMotion motion_on(const AnyPath& path, double t, std::size_t segment) noexcept {
    return path.linear_motion_on(segment, t);
  }

  /// What `of` gives of the curve that has the time; within a gap of no time.
  template <class Of>
  [[nodiscard]] auto on(double t, std::size_t segment, Of of) const noexcept {
    const Place& place = places_.empty() ? only_key : places_[segment];
    const auto& before = stretches_[place.stretch];
    if (!place.is_gap) return of(before, t, place.segment);
    const auto& next = stretches_[place.stretch + 1];
    if (t >= next.knots().front()) return of(next, t, std::size_t{0});
    return of(before, t <= before.knots().back() ? t : std::numeric_limits<double>::quiet_NaN(), place.segment);
  }

  static constexpr Place only_key{0, 0, false};

  std::vector<AnyCurveThrough<P>> stretches_;
  Knots knots_;
  std::vector<Place> places_{};
};

/// The time in the middle of a segment [s].
[[nodiscard]] inline double middle_of(const Knots& knots, std::size_t segment) noexcept {
  const auto t = knots.times();
  return t[segment] + 0.5 * (t[segment + 1] - t[segment]);
}

/// Whether a segment lies between two stretches of keys, where the curve has nothing: it has no time, or no points.
[[nodiscard]] inline bool is_gap(const AnyCurve& curve, std::size_t segment) noexcept {
  return curve.knots().span(segment).step() == 0.0 ||
         curve.orientation_on(segment, middle_of(curve.knots(), segment)).coeffs().hasNaN();
}
[[nodiscard]] inline bool is_gap(const AnyPath& path, std::size_t segment) noexcept {
  return path.knots().span(segment).step() == 0.0 ||
         path.position_on(segment, middle_of(path.knots(), segment)).hasNaN();
}

}}  // namespace orispline
