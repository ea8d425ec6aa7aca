// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <numbers>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// With 1 the body rests between keys that are equal but for rounding.
inline constexpr Parameter hold_setting{"hold", 0.0, 0.0, 1.0, false};
/// The body rests between keys that turn no farther [rad].
inline constexpr Parameter rest_angle_setting{"rest-angle", 0.0, 0.0, std::numbers::pi, false};

/// Steps from key to key that are rests, the longest: none where less than 0.
struct RestLimits {
  double angle = -1.0;   ///< [rad]
  double length = -1.0;  ///< of positions [m]
};

/// By both settings. Errors: bad_argument for a `hold` that is not whole.
[[nodiscard]] inline Expected<RestLimits> rest_limits(const FamilySettings& settings) {
  return settings.whole(hold_setting.name).map([&](int hold) {
    RestLimits limits = hold == 1 ? RestLimits{rest_angle, rest_length} : RestLimits{};
    if (const double stated = settings.per_key(rest_angle_setting.name)[0]; stated > 0.0)
      limits.angle = std::max(limits.angle, stated);
    return limits;
  });
}

}}}  // namespace orispline::families
