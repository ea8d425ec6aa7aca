// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::contract {

/// Every parameter random per key within a moderate range: continuity may not depend on them but as declared. Kept are
/// the degree or order, which decides on it, β₁, which is the very ratio of the rates at a joint, where joints are
/// truly G2 β₂, which is the very jump of the acceleration, and the `continuity` of Kochanek–Bartels, which makes the
/// rates differ.
inline CurveOptions random_parameters(const FamilyInfo& family, std::size_t keys, std::uint64_t seed) {
  testing_support::Dice dice(seed);
  CurveOptions options;
  for (const Parameter& parameter : family.parameters) {
    if (!parameter.per_key || parameter.name == "beta1" || parameter.name == "continuity") continue;
    if (family.name == "beta-g2" && parameter.name == "beta2") continue;
    std::vector<double> values(keys);
    for (double& value : values) value = parameter.initial + dice.between(0.05, 0.4);
    options.parameters[std::string(parameter.name)] = values;
  }
  return options;
}

}  // namespace orispline::contract
