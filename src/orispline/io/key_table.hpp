// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The table as CSV; a column of a name that the table has takes its place, others follow in the order of their names.
/// Every row has a cell for every name: an empty one where the row or the column is too short, and none beyond the
/// names.
[[nodiscard]] std::string csv_with_columns(const KeyTable& table, const NumberColumns& columns);

}}}  // namespace orispline::io
