// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <batch/sampled.hpp>

namespace orispline::testing_support {

/// How far the body rates of a baked curve are from the curve's own, at many times of every piece: the difference of
/// order k times hᵏ over the tolerance, h the length of the piece; ω, α and jerk.
template <class T>
[[nodiscard]] Eigen::Array3d largest_rate_differences(const AnyCurve& curve, double tolerance) {
  constexpr std::size_t per_piece = 40;
  const BakedCurve<T> baked = bake<T>(curve, tolerance).value();
  Eigen::Array3d largest = Eigen::Array3d::Zero();
  for (std::size_t i = 0; i < baked.knots().segments(); ++i) {
    const KnotSpan span = baked.knots().span(i);
    const double h = span.step();
    std::vector<double> times;
    for (std::size_t k = 0; k < per_piece; ++k)
      times.push_back(span.start() + h * static_cast<double>(k) / static_cast<double>(per_piece));
    Sampled<T> samples(per_piece, Wanted::jerk);
    EXPECT_TRUE(sample<T>(baked, times, samples.spans()));
    for (std::size_t k = 0; k < per_piece; ++k) {
      const Motion wanted = curve.motion(times[k]);
      largest = largest.max(Eigen::Array3d(h * (samples.velocity(k) - wanted.angular_velocity).norm(),
                                           h * h * (samples.acceleration(k) - wanted.angular_acceleration).norm(),
                                           h * h * h * (samples.jerk(k) - wanted.angular_jerk).norm()) /
                            tolerance);
    }
  }
  return largest;
}

/// The same of half of the tolerance times the first Chebyshev polynomial that a piece cannot hold, T₁₀ or in float T₆,
/// at an end, and a little for those after it: Tₙ' = n², Tₙ'' = n² (n² - 1)/3, Tₙ''' = n² (n² - 1) (n² - 4)/15 there,
/// by (2/h)ᵏ.
template <class T>
[[nodiscard]] Eigen::Array3d allowed_rate_differences() {
  constexpr int n = batch::baked_degree<T> + 1;
  constexpr double square = n * n, later_terms = sizeof(T) == 8 ? 1.05 : 1.25;  // of the shorter series they are more
  return later_terms * Eigen::Array3d(square, 2.0 * square * (square - 1.0) / 3.0,
                                      4.0 * square * (square - 1.0) * (square - 4.0) / 15.0);
}

}  // namespace orispline::testing_support
