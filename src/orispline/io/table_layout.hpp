// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct ReadOptions;

/// How the rows of a table are to be read.
struct TableLayout {
  KeyColumns columns{};
  std::vector<std::string> names{};  ///< of all columns: those of the header, else such as one could have
  enum class FirstRow { header, key } first_row = FirstRow::key;
};

/// Cells of a row without the empty ones at its end.
[[nodiscard]] ORISPLINE_EXPORT std::size_t width_of(std::span<const std::string_view> cells) noexcept;

/// The option that asks for something that only a header can give, if any.
[[nodiscard]] ORISPLINE_EXPORT std::optional<std::string_view> header_option(const ReadOptions& options);

/// The error (bad_argument) of an option that contradicts the row of the table.
[[nodiscard]] ORISPLINE_EXPORT tl::unexpected<Error> misplaced(const TextTable& table, std::string_view option,
                                                               std::string message);

/// The columns, or what is wrong with them at the row of the table.
[[nodiscard]] ORISPLINE_EXPORT Expected<KeyColumns> located(const TextTable& table, Expected<KeyColumns> columns);

}}}  // namespace orispline::io
