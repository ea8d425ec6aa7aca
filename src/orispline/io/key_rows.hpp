// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/io/key_file.hpp>

namespace orispline::io {

/// Gathers the keys of a table row by row, checks and repairs them.
class KeyRows {
 public:
  KeyRows(std::string path, const FormatInfo& format, KeyColumns columns, const ReadOptions& options);

  /// Reads the row that the table stands at. Errors (bad_data): a cell is no number, the time does not increase.
  [[nodiscard]] Expected<void> add(const TextTable& table);
  /// The keys of all rows. Errors (bad_data): there are none; two that were sorted have the same time.
  [[nodiscard]] Expected<KeyFile> finish() &&;

 private:
  [[nodiscard]] Expected<bool> append_time(const Decimal& time, std::string_view text, std::size_t line);
  [[nodiscard]] Expected<void> sort();

  KeyColumns columns_;
  ReadOptions options_;
  KeyFile file_;
  Decimal first_, latest_;       // times in the unit of the file
  std::size_t latest_line_ = 0;  // of `latest_`
  std::vector<Decimal> times_;   // of all rows, gathered only to be sorted
};

}  // namespace orispline::io
