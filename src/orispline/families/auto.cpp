// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto.hpp>

#include <orispline/families/auto_rates.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// The rates at the keys, at rest where a step is no longer than that [rad], [m].
AutoRates rates_along(const Keyframes& keys, Through through, std::size_t reach, double longest_rest) {
  AutoRates along(keys, through, reach, reach);
  along.guard();
  along.rest_within(longest_rest);
  return along;
}

Expected<ChartCurve<5>> curve_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return rest_limits(settings).map([&](const RestLimits& rests) {
    AutoRates along = rates_along(keys, Through::orientations, reach, rests.angle);
    return quintics_through(keys, along, [&along](std::size_t i) { return along.rates(i); });
  });
}

Expected<HermitePath<5>> path_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return rest_limits(settings).map([&](const RestLimits& rests) {
    AutoRates along = rates_along(keys, Through::positions, reach, rests.length);
    return quintic_path_through(keys, along, [&along](std::size_t i) { return along.rates(i); });
  });
}

}  // namespace

Expected<ChartCurve<5>> Auto::curve(const Keyframes& keys, const FamilySettings& settings) {
  return curve_of_reach(keys, 3, settings);
}
Expected<HermitePath<5>> Auto::path(const Keyframes& keys, const FamilySettings& settings) {
  return path_of_reach(keys, 3, settings);
}
Expected<ChartCurve<5>> Auto5::curve(const Keyframes& keys, const FamilySettings& settings) {
  return curve_of_reach(keys, 2, settings);
}
Expected<HermitePath<5>> Auto5::path(const Keyframes& keys, const FamilySettings& settings) {
  return path_of_reach(keys, 2, settings);
}

}}}  // namespace orispline::families
