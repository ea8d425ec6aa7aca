// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Catmull–Rom in time: cubic Hermite pieces whose velocity at a key is that of the parabola through it and its two
/// neighbours, at the ends that of the chord. C1 on any key times, exact at constant velocity.
class CatmullRomPath {
 public:
  static constexpr int degree = 3;

  /// At least two keys, with positions. `tension` scales the velocities.
  explicit CatmullRomPath(const Keyframes& keys, const PerKey& tension = PerKey({1.0}));

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Vector3<T> point(const T& t, std::size_t segment) const noexcept {
    const KnotSpan span = knots_.span(segment);
    const auto basis = bernstein_basis<3>(span.normalised(t));
    const Eigen::Vector3d &p0 = positions_[segment], &p1 = positions_[segment + 1];
    const double third = span.step() / 3.0;
    const Eigen::Vector3d c1 = p0 + third * velocities_[segment], c2 = p1 - third * velocities_[segment + 1];
    return constant<T>(p0) * basis[0] + constant<T>(c1) * basis[1] + constant<T>(c2) * basis[2] +
           constant<T>(p1) * basis[3];
  }

 private:
  Knots knots_;
  std::vector<Eigen::Vector3d> positions_, velocities_;
};

}}  // namespace orispline
