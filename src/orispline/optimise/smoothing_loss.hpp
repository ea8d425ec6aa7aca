// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/math/elementary.hpp>
#include <orispline/optimise/smoothing.hpp>

namespace orispline::optimise {

/// ρ(s) and ρ'(s).
struct LossValue {
  double value, weight;
};

/// Of a squared residual s in units of the variance; the formulas stand with `Loss`.
[[nodiscard]] inline LossValue loss_at(Loss loss, double s, double threshold) noexcept {
  const double bound = threshold * threshold;
  switch (loss) {
    case Loss::huber: {
      if (s <= bound) return {s, 1.0};
      const double root = std::sqrt(s);
      return {2.0 * threshold * root - bound, threshold / root};
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
