// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/math/elementary.hpp>
#include <orispline/optimise/smoothing.hpp>

namespace orispline::optimise {

/// ρ(s), ρ'(s), and the share of the weight ρ' that is left to the second derivative along the residual.
struct LossValue {
  double value, weight, curvature = 1.0;
};

/// Beyond Huber's threshold the cost is straight along the residual: a share of 0, but a little keeps the step finite.
/// The other losses bend downward there and keep the whole weight, which majorises them.
inline constexpr double straight_curvature = 0.1;

/// Of a squared residual s in units of the variance; the formulas stand with `Loss`.
[[nodiscard]] inline LossValue loss_at(Loss loss, double s, double threshold) noexcept {
  const double bound = threshold * threshold;
  switch (loss) {
    case Loss::huber: {
      if (s <= bound) return {s, 1.0};
      const double root = std::sqrt(s);
      return {2.0 * threshold * root - bound, threshold / root, straight_curvature};
    }
    case Loss::cauchy:
      return {bound * elementary::natural_logarithm(1.0 + s / bound), 1.0 / (1.0 + s / bound)};
    case Loss::tukey: {
      const double rest = std::max(0.0, 1.0 - s / bound);
      return {bound / 3.0 * (1.0 - rest * rest * rest), rest * rest};
    }
    case Loss::squares:
      break;
  }
  return {s, 1.0};
}

}  // namespace orispline::optimise
