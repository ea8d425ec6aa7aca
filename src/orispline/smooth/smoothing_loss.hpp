// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// ρ(s), ρ'(s), and the share of the weight ρ' that is left to the second derivative along the residual.
struct LossValue {
  double value, weight, curvature = 1.0;
};

/// Beyond Huber's threshold the cost is straight along the residual: a share of 0, but a little keeps the step finite.
/// Tukey's bends downward there and keeps the whole weight, which majorises it.
inline constexpr double straight_curvature = 0.1;

/// Of a squared residual s in units of the variance; the formulas stand with `LossFunction`.
[[nodiscard]] inline LossValue loss_at(LossFunction loss, double s, double threshold) noexcept {
  const double bound = threshold * threshold;
  switch (loss) {
    case LossFunction::huber: {
      if (s <= bound) return {s, 1.0};
      const double root = std::sqrt(s);
      return {2.0 * threshold * root - bound, threshold / root, straight_curvature};
    }
    case LossFunction::tukey: {
      const double rest = std::max(0.0, 1.0 - s / bound);
      return {bound / 3.0 * (1.0 - rest * rest * rest), rest * rest};
    }
    case LossFunction::l2:
      break;
  }
  return {s, 1.0};
}

}}  // namespace orispline
