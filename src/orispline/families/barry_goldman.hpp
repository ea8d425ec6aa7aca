// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <numeric>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/one_axis.hpp>
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

    /// From one point's time to another's.
    template <Number T>
    [[nodiscard]] T fraction(const T& t, std::size_t from, std::size_t to) const noexcept {
      return (t - T(times[from])) / (times[to] - times[from]);
    }
    /// The same seen from the other one: 0 there, -1 at the first.
    template <Number T>
    [[nodiscard]] T fraction_after(const T& t, std::size_t from, std::size_t to) const noexcept {
      return (t - T(times[to])) / (times[to] - times[from]);
    }
    /// The left side of the pyramid where its base is about one axis: a rotation vector from the second point [rad].
    template <Number T>
    [[nodiscard]] Vector3<T> left(const T& t) const noexcept {
      return mixed<T>(constant<T>(steps[0]) * fraction_after(t, 0, 1), constant<T>(steps[1]) * fraction(t, 1, 2),
                      fraction(t, 0, 2));
    }
    /// The right side of it there: a rotation vector from the third point [rad].
    template <Number T>
    [[nodiscard]] Vector3<T> right(const T& t) const noexcept {
      return mixed<T>(constant<T>(steps[1]) * fraction_after(t, 1, 2), constant<T>(steps[2]) * fraction(t, 2, 3),
                      fraction(t, 1, 3));
    }
  };

  Pyramid(Knots knots, std::vector<Segment> segments) : knots_(std::move(knots)), segments_(std::move(segments)) {
    ORISPLINE_EXPECT(segments_.size() == knots_.segments());
    for (const Segment& segment : segments_) winding_.push_back(winding_of(segment));
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] PointOver<Point, T> point(const T& t, std::size_t segment) const noexcept {
    const Segment& s = segments_[segment];
    const Winding winds = winding_[segment];
    const T u = s.fraction(t, 1, 2);
    if (winds.whole)
      return displaced_about_one_axis<T>(s.points[1], s.points[2], s.steps[1],
                                         mixed<T>(s.left(t), Vector3<T>(constant<T>(s.steps[1]) + s.right(t)), u), u);
    const auto base = [&](std::size_t k) {
      return displaced<T>(constant<T>(s.points[k]), constant<T>(s.steps[k]) * s.fraction(t, k, k + 1));
    };
    const auto before = base(0), here = base(1), after = base(2);
    return on_geodesic<T>(winds.left ? displaced<T>(constant<T>(s.points[1]), s.left(t))
                                     : on_geodesic<T>(before, here, s.fraction(t, 0, 2)),
                          winds.right ? displaced<T>(constant<T>(s.points[2]), s.right(t))
                                      : on_geodesic<T>(here, after, s.fraction(t, 1, 3)),
                          u);
  }

 private:
  /// What comes a full turn apart while it is blended, about one axis: the base of a side, or all.
  struct Winding {
    bool left = false, right = false, whole = false;
  };

  /// Each pair of the base is farthest apart where the segment ends or begins, the two sides in its middle.
  [[nodiscard]] static Winding winding_of(const Segment& s) noexcept {
    if constexpr (std::same_as<Point, Eigen::Vector3d>) return {};
    const double start = s.times[1], end = s.times[2], middle = std::midpoint(start, end);
    const Eigen::Vector3d before = s.steps[0] * s.fraction_after(end, 0, 1), here = s.steps[1],
                          after = s.steps[2] * s.fraction(start, 2, 3);
    Winding winding{.left = wraps(here - before) && have_one_axis(std::array{before, here}),
                    .right = wraps(here + after) && have_one_axis(std::array{here, after})};
    const bool winds = winding.left || winding.right || wraps(here + s.right(middle) - s.left(middle));
    winding.whole = winds && have_one_axis(std::array{before, here, after});
    return winding;
  }

  Knots knots_;
  std::vector<Segment> segments_;
  std::vector<Winding> winding_;  ///< by segment; in space nothing winds
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
