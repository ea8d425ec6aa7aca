// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/curve/keyframe.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// Chooses the signs of keys that come one after the other, and notices what there is to report of them.
struct KeyAlignment {
  KeyframeReport report{};
  bool negated = false;  ///< whether the key before was

  /// The next unit orientation with its sign; `norm`: what it was divided by. `before`: the one before it, with its
  /// sign; null for the first.
  Eigen::Quaterniond next(Eigen::Quaterniond unit, double norm, Signs signs, const Eigen::Quaterniond* before) {
    const double norm_error = std::abs(norm - 1.0);
    report.largest_norm_error = std::max(report.largest_norm_error, norm_error);
    if (norm_error > unit_norm_tolerance) ++report.non_unit_keys;
    const bool against_before = before && unit.dot(*before) < 0.0;
    if (before && against_before != negated) ++report.sign_flips;
    negated = signs == Signs::shortest && against_before;
    if (negated) unit.coeffs() = -unit.coeffs();
    return unit;
  }
};

}  // namespace orispline::inline ORISPLINE_ABI
