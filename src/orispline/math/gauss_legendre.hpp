// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include <orispline/base/abi.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A node of a quadrature rule on [0, 1].
struct QuadratureNode {
  double u, weight;  ///< the weights of a rule sum to 1
};

/// The Gauss–Legendre rule with N nodes on [0, 1]: exact for polynomials of degree 2N-1.
template <std::size_t N>
[[nodiscard]] std::array<QuadratureNode, N> gauss_legendre() noexcept {
  std::array<QuadratureNode, N> rule{};
  for (std::size_t i = 0; i < N; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(N) + 0.5);
    double x = elementary::sine_cosine(angle).cosine;
    double slope = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {  // Newton's method, quadratic from this start
      double before = 1.0, value = x;
      for (std::size_t m = 2; m <= N; ++m) {
        const double order = static_cast<double>(m);
        const double next = ((2.0 * order - 1.0) * x * value - (order - 1.0) * before) / order;
        before = value;
        value = next;
      }
      slope = static_cast<double>(N) * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    rule[i] = {.u = 0.5 * (1.0 + x), .weight = 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return rule;
}

}}  // namespace orispline
