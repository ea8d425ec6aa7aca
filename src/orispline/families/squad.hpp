// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/catmull_rom_path.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/handle_rates.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// A chain of spherical quadrangles: segment i is squad(Q_i, A_i, B_{i+1}, Q_{i+1}; u).
///
/// The inner quaternions A (leaving a key) and B (arriving at it) are what the two families below differ in. Not
/// cumulative: its rates come from jets through the whole quaternion.
class SquadCurve {
 public:
  /// The inner quaternions of a key as rotation vectors from it [rad]: on leaving it and on arriving at it.
  struct Handles {
    Eigen::Vector3d leaving, arriving;
  };

  /// `handles(i)` are those of key i.
  template <class HandlesOf>
  SquadCurve(const Keyframes& keys, HandlesOf handles) : knots_({keys.times().begin(), keys.times().end()}) {
    const auto q = keys.orientations();
    pieces_.reserve(q.size() - 1);
    Handles here = handles(0);
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      const Handles next = handles(i + 1);
      const Eigen::Quaterniond leaving = q[i] * exp<double>(here.leaving);
      const Eigen::Quaterniond arriving = q[i + 1] * exp<double>(next.arriving);
      const Eigen::Vector3d step = increment<double>(q[i], q[i + 1]);
      pieces_.push_back({.outer = q[i],
                         .inner = leaving,
                         .outer_increment = step,
                         .inner_increment = inner_increment(q[i], leaving, step, q[i + 1], arriving)});
      here = next;
    }
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    const T u = knots_.span(segment).normalised(t);
    const SquadForm& piece = pieces_[segment];
    const Quaternion<T> outer = constant<T>(piece.outer) * exp<T>(constant<T>(piece.outer_increment) * u);
    const Quaternion<T> inner = constant<T>(piece.inner) * exp<T>(constant<T>(piece.inner_increment) * u);
    return slerp<T>(outer, inner, T(2.0) * u * (T(1.0) - u));
  }

  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept { return pieces_[segment]; }

 private:
  /// From one inner quaternion to the other, about one axis as far round as keeps them within a turn of the outer arc.
  [[nodiscard]] static Eigen::Vector3d inner_increment(const Eigen::Quaterniond& key, const Eigen::Quaterniond& leaving,
                                                       const Eigen::Vector3d& step, const Eigen::Quaterniond& next,
                                                       const Eigen::Quaterniond& arriving) noexcept;

  Knots knots_;
  std::vector<SquadForm> pieces_;  // with the increments of their arcs, formed once
};

/// Eberly's spline of squads in the normalised parameter: C1 on uniform knots.
///
/// Inner quaternions that keys have are the control points of their segments, in the words of Eberly's section 6
///
///     S_n(t) = Slerp(2t(1-t); Slerp(t; q_n, q_{n+1}), Slerp(t; a_n, b_{n+1}))
///
/// with a_n of Keyframes::inner_leaving() and b_n of inner_arriving(), whatever the end rules; one that is free is
/// chosen by (22). That which would lie outside the curve, b of the first key and a of the last one, is not used.
struct Squad {
  static constexpr std::array ends{EndRule::key, EndRule::phantom};
  static constexpr FamilyInfo info{.name = "squad",
                                   .title = "Spherical quadrangle interpolation",
                                   .source = "Eberly, (18) and (22); Shoemake 1987",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .ends = ends,
                                   .order_with_inner_quaternions = 0};
  [[nodiscard]] static Expected<SquadCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// Catmull–Rom in time: a quadrangle of positions would be C1 on even key times only.
  [[nodiscard]] static Expected<CatmullRomPath> path(const Keyframes& keys, const FamilySettings&) {
    return CatmullRomPath(keys);
  }
};

/// Squad with inner quaternions that know the key times: C1 in time on any knots.
///
/// Geier's pass a key with the rate of the parabola through its neighbours, Boyle's with the mean of the rates on
/// either side.
struct SquadTimed {
  static constexpr std::array<std::string_view, 2> variants{"geier", "boyle"};
  static constexpr std::array choices{Choice{"variant", variants}};
  static constexpr std::array ends{EndRule::reflect, EndRule::natural, EndRule::repeat};
  static constexpr FamilyInfo info{
      .name = "squad-timed",
      .title = "Squad made C1 for uneven key times",
      .source = "Geier's and Boyle's variants for uneven times, docs/families/squad-timed.md",
      .continuity_uniform = 1,
      .continuity_uneven = 1,
      .keeps_constant_rate_uniform = true,
      .keeps_constant_rate_uneven = true,
      .support_keys = 4,
      .choices = choices,
      .ends = ends};
  [[nodiscard]] static Expected<SquadCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The handle that turns farthest; C1 is lost from a full turn on.
  [[nodiscard]] static HandleTurn widest_handle(const Keyframes& keys, const FamilySettings& settings);
  /// That of `squad`.
  [[nodiscard]] static Expected<CatmullRomPath> path(const Keyframes& keys, const FamilySettings&) {
    return CatmullRomPath(keys);
  }
};

}}}  // namespace orispline::families
