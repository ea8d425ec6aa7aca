// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline::testing_support {

/// Orders 0 to 3 as a type-erased curve tells them: by its body rates.
[[nodiscard]] inline std::array<Eigen::Vector4d, 4> motion_orders(const AnyCurve& curve, double t, Side side) {
  const Motion m = curve.motion(t, side);
  const auto padded = [](const Eigen::Vector3d& v) { return Eigen::Vector4d(v.x(), v.y(), v.z(), 0.0); };
  return {m.orientation.coeffs(), padded(m.angular_velocity), padded(m.angular_acceleration), padded(m.angular_jerk)};
}

/// Largest jump of each derivative of the orientation at the inner knots, relative to its largest size there or, where
/// it vanishes at all of them, in the middle of the segments. A type-erased curve has orders 0 to 3.
template <std::size_t Orders = 5, class C>
[[nodiscard]] auto relative_jumps(const C& curve) {
  constexpr bool erased = std::same_as<C, AnyCurve>;
  constexpr std::size_t orders = erased ? 4 : Orders;
  const auto at = [&](std::size_t segment, double t, Side side) {
    if constexpr (erased) return motion_orders(curve, t, side);
    else return quaternion_derivatives<C, Orders>(curve, t, segment);
  };
  std::array<double, orders> jumps{}, sizes{}, inside{};
  for (std::size_t segment = 1; segment < curve.knots().segments(); ++segment) {
    const double t = curve.knots().times()[segment];
    const auto left = at(segment - 1, t, Side::left), right = at(segment, t, Side::right);
    const auto middle = at(segment, t + 0.5 * curve.knots().span(segment).step(), Side::right);
    for (std::size_t k = 0; k < orders; ++k) {
      jumps[k] = std::max(jumps[k], (left[k] - right[k]).norm());
      sizes[k] = std::max({sizes[k], left[k].norm(), right[k].norm()});
      inside[k] = std::max(inside[k], middle[k].norm());
    }
  }
  for (std::size_t k = 0; k < orders; ++k) jumps[k] /= sizes[k] > tolerance::algebra * inside[k] ? sizes[k] : inside[k];
  return jumps;
}

}  // namespace orispline::testing_support
