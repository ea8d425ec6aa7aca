// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <support/typed_curves.hpp>

namespace orispline::testing_support {

/// Largest jump of each derivative of the orientation at the inner knots, relative to its largest size there.
template <std::size_t Orders = 5, Curve C>
[[nodiscard]] std::array<double, Orders> relative_jumps(const C& curve) {
  std::array<double, Orders> jumps{}, sizes{};
  for (std::size_t segment = 1; segment < curve.knots().segments(); ++segment) {
    const double t = curve.knots().times()[segment];
    const auto left = quaternion_derivatives<C, Orders>(curve, t, segment - 1);
    const auto right = quaternion_derivatives<C, Orders>(curve, t, segment);
    for (std::size_t k = 0; k < Orders; ++k) {
      jumps[k] = std::max(jumps[k], (left[k] - right[k]).norm());
      sizes[k] = std::max({sizes[k], left[k].norm(), right[k].norm()});
    }
  }
  for (std::size_t k = 0; k < Orders; ++k) jumps[k] /= sizes[k];
  return jumps;
}

}  // namespace orispline::testing_support
