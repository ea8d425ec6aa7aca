// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// sin(half_turn_margin / 2)
inline constexpr double cosine_near_half_turn = 0.008726535498373935;

/// Chooses the signs of keys that come one after the other, and notices what there is to report of them.
struct KeyAlignment {
  KeyframeReport report{};
  bool negated = false;  ///< whether the key before was
  std::size_t keys = 0;

  /// The next unit orientation with its sign; `norm`: what it was divided by. `before`: the one before it, with its
  /// sign; null for the first.
  Eigen::Quaterniond next(Eigen::Quaterniond unit, double norm, Signs signs, const Eigen::Quaterniond* before) {
    const double norm_error = std::abs(norm - 1.0);
    report.largest_norm_error = std::max(report.largest_norm_error, norm_error);
    if (norm_error > unit_norm_tolerance) ++report.non_unit_keys;
    const double cosine = before ? unit.dot(*before) : 1.0;  // of half the angle between them
    const bool against_before = cosine < 0.0;
    if (signs == Signs::shortest && std::abs(cosine) <= cosine_near_half_turn)
      if (report.near_half_turns++ == 0) report.first_near_half_turn = keys - 1;
    ++keys;
    if (before && against_before != negated) ++report.sign_flips;
    negated = signs == Signs::shortest && against_before;
    if (negated) unit.coeffs() = -unit.coeffs();
    return unit;
  }
};

}}  // namespace orispline
