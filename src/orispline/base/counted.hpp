// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// `1 key`, `2 keys`
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

}}  // namespace orispline
