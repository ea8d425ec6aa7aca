// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/families/blending/rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// Where the body moves on at a key in one direction.
struct MotionCondition {
  /// On the parameters, such as `1 − a ≠ 0`; empty where it always does.
  std::string text;
  /// Whether the two sides vanish together, so that the ratio of their rates depends on lengths alone.
  bool is_of_both_sides;
};

/// An end derivative that depends on parameters is the condition itself. A segment that begins at the key gives the
/// names. What is too long to be read is named as a derivative, such as `β̃2′(1)`.
[[nodiscard]] MotionCondition motion_condition(const BlendingData& data, const Rows& rows);

/// A function of a row, in words; rows are counted from 1.
[[nodiscard]] std::string function_name(std::size_t row, std::size_t order);

}}}  // namespace orispline::blending
