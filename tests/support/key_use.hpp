// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// The step of a random walk on such times [rad]: as wide as asked for, or as the family takes.
[[nodiscard]] inline double step_on(const FamilyInfo& family, Spacing spacing, double wanted) {
  return spacing == Spacing::even ? wanted : std::min(wanted, family.key_use.widest_turn);
}

/// Hard keys may be answered by the error that the equations of the method were not solved for them.
[[nodiscard]] inline bool may_refuse(const FamilyInfo& family) { return family.key_use.widest_turn < 10.0; }

}  // namespace orispline::testing_support
