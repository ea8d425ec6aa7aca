// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/curve/family.hpp>

namespace orispline::cli {

/// What the families say about themselves, one object each.
[[nodiscard]] std::string json_of(std::span<const FamilyInfo> families);

}  // namespace orispline::cli
