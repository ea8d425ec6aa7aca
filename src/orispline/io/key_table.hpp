// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orispline::io {

/// The text of a table of keys, column by column as it was read.
struct KeyTable {
  std::vector<std::string> names{};
  std::vector<std::vector<std::string>> rows{};  ///< one cell per name, one row per key
};

/// Columns of numbers by name, one number per key.
using NumberColumns = std::map<std::string, std::vector<double>, std::less<>>;

/// The table as CSV; a column of a name that the table has takes its place, others follow in the order of their names.
[[nodiscard]] std::string csv_with_columns(const KeyTable& table, const NumberColumns& columns);

}  // namespace orispline::io
