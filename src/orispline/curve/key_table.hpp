// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The text of a table of keys, column by column as it was read.
struct KeyTable {
  std::vector<std::string> names{};
  std::vector<std::vector<std::string>> rows{};  ///< one cell per name, one row per key
};

}}  // namespace orispline
