// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// The step of a random walk on such times [rad]: as wide as asked for, or as the family takes.
[[nodiscard]] inline double step_on(const FamilyInfo& family, Spacing spacing, double wanted) {
  return spacing == Spacing::even ? wanted : std::min(wanted, family.key_use.widest_turn);
}

/// Hard keys may be answered by the error that the equations of the method were not solved for them.
[[nodiscard]] inline bool may_refuse(const FamilyInfo& family) { return family.key_use.widest_turn < 10.0; }

/// Keys at very uneven times may be answered by the error that the rates there would wind the curve beyond what doubles
/// tell apart.
[[nodiscard]] inline bool is_wound_too_far(const FamilyInfo& family, const Error& error) {
  return family.rate_orders > 0 && error.code == ErrorCode::bad_data && error.where.key.has_value() &&
         error.message.find(" wind the curve between the two by up to ") != std::string::npos;
}

}  // namespace orispline::testing_support
