// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the body rates of clamped ends are called in the text form of a method.
inline constexpr std::string_view start_rate_name = "start_rate", end_rate_name = "end_rate";

}}  // namespace orispline
