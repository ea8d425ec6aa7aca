// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto.hpp>

#include <orispline/families/auto_rates.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

Expected<bool> holds(const FamilySettings& settings) {
  return settings.whole("hold").map([](int hold) { return hold == 1; });
}

AutoRates rates_along(const Keyframes& keys, Through through, std::size_t reach, bool hold) {
  AutoRates along(keys, through, reach, reach);
  along.guard();
  if (hold) along.hold();
  return along;
}

Expected<ChartCurve<5>> curve_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return holds(settings).map([&](bool hold) {
    AutoRates along = rates_along(keys, Through::orientations, reach, hold);
    return quintics_through(keys, along, [&along](std::size_t i) { return along.rates(i); });
  });
}

Expected<HermitePath<5>> path_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return holds(settings).map([&](bool hold) {
    AutoRates along = rates_along(keys, Through::positions, reach, hold);
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
