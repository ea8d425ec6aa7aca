// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/families/rest_settings.hpp>
#include <orispline/fields/quantity.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a setting of a method measures, whose units people may type behind its number; null for a plain number.
[[nodiscard]] constexpr const Quantity* quantity_of_setting(std::string_view setting) noexcept {
  return setting == families::rest_angle_setting.name ? &quantities::angle : nullptr;
}

}}  // namespace orispline
