// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Which cell of a row is the time, and how it counts.
struct TimeColumn {
  std::size_t index = 0;
  Fraction unit{};  ///< [s]
  bool states_unit = false;
  std::optional<RestOfTime> rest{};
};

/// The one that a header names. Errors, at the row of the table.
[[nodiscard]] Expected<TimeColumn> time_column(const TextTable& table, std::span<const std::string_view> header,
                                               const ReadOptions& options);

/// The time in the row [s]; what is found out of the unit goes into the column, and is warned of.
[[nodiscard]] Expected<Decimal> time_of(const TextTable& table, TimeColumn& column, const Clock& clock,
                                        std::vector<Warning>& warnings);

}}}  // namespace orispline::io
