// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::contract {

/// Whether a parameter is by its meaning a jump at a joint: β₁, which is the very ratio of the rates, where joints are
/// truly G2 β₂, which is the very jump of the acceleration, and the `continuity` of Kochanek–Bartels.
inline bool is_a_jump(const FamilyInfo& family, std::string_view parameter) {
  return parameter == "beta1" || parameter == "continuity" || (family.name == "beta-g2" && parameter == "beta2");
}

/// Every parameter random per key within a moderate range: continuity may not depend on them but as declared. Kept are
/// the degree or order, which decides on it, and those that are jumps.
inline CurveOptions random_parameters(const FamilyInfo& family, std::size_t keys, std::uint64_t seed) {
  testing_support::Dice dice(seed);
  CurveOptions options;
  for (const Parameter& parameter : family.parameters) {
    if (!parameter.per_key || is_a_jump(family, parameter.name)) continue;
    std::vector<double> values(keys);
    for (double& value : values) value = parameter.initial + dice.between(0.05, 0.4);
    options.parameters[std::string(parameter.name)] = values;
  }
  return options;
}

}  // namespace orispline::contract
