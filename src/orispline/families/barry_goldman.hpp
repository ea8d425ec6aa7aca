// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Barry and Goldman's pyramid over four points of each segment, for orientations by slerps, for positions by lines.
///
/// Its base are the geodesics through neighbouring points in time; two more stages blend them: C1 in time.
template <CurvePoint Point>
class Pyramid {
 public:
  /// Four points around a segment with their times, and the displacement from each to the next.
  struct Segment {
    std::array<Point, 4> points;
    std::array<double, 4> times;
    std::array<Displacement<Point>, 3> steps;
  };

  Pyramid(Knots knots, std::vector<Segment> segments) : knots_(std::move(knots)), segments_(std::move(segments)) {
    ORISPLINE_EXPECT(segments_.size() == knots_.segments());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] PointOver<Point, T> point(const T& t, std::size_t segment) const noexcept {
    const Segment& s = segments_[segment];
    const auto fraction = [&](std::size_t from, std::size_t to) -> T {
      return (t - T(s.times[from])) / (s.times[to] - s.times[from]);
    };
    const auto base = [&](std::size_t k) {
      return displaced<T>(constant<T>(s.points[k]), constant<T>(s.steps[k]) * fraction(k, k + 1));
    };
    const auto before = base(0), here = base(1), after = base(2);
    return on_geodesic<T>(on_geodesic<T>(before, here, fraction(0, 2)), on_geodesic<T>(here, after, fraction(1, 3)),
                          fraction(1, 2));
  }

 private:
  Knots knots_;
  std::vector<Segment> segments_;
};

/// Catmull–Rom with slerps: C1 in time on any knots.
struct BarryGoldman {
  static constexpr std::array ends{EndRule::natural};
  static constexpr FamilyInfo info{.name = "barry-goldman",
                                   .title = "Barry-Goldman pyramid of slerps",
                                   .source = "Barry & Goldman 1988; docs/families/barry-goldman.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .ends = ends,
                                   .key_use = {.widest_turn = 0.8}};  // geodesics go on for ten times their length
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<Pyramid<P>> curve(const Keyframes& keys, const FamilySettings&);
};

}}}  // namespace orispline::families
