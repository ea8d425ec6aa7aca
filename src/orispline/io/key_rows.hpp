// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct KeyRow;

/// Of a quaternion that is too far from a unit one to be read without being asked.
[[nodiscard]] Error norm_refused(double norm, Where where);

/// Gathers the keys of a table row by row, checks and repairs them. They may be taken out in pieces.
class KeyRows {
 public:
  KeyRows(std::string path, const FormatInfo& format, KeyColumns columns, const ReadOptions& options);

  /// Reads the row that the table stands at. Errors (bad_data): a cell is no number, the time does not increase.
  [[nodiscard]] Expected<void> add(const TextTable& table);
  /// Says that there are no more rows, and sorts those that there are. Errors (bad_data): there were no keys at all;
  /// two that were sorted have the same time.
  [[nodiscard]] Expected<void> complete();
  /// Takes the gathered keys out.
  [[nodiscard]] KeyFile take();

  /// Keys that are gathered.
  [[nodiscard]] std::size_t size() const noexcept { return file_.lines.size(); }
  [[nodiscard]] const ReadOptions& options() const noexcept { return options_; }
  [[nodiscard]] const KeyColumns& columns() const noexcept { return columns_; }

 private:
  [[nodiscard]] Expected<Eigen::Quaterniond> orientation_of(const Eigen::Quaterniond& stated, Where where);
  [[nodiscard]] Expected<Eigen::Quaterniond> normalised(Eigen::Quaterniond q, Where where);
  [[nodiscard]] Expected<void> settle_clock(const TextTable& table);
  void settle_time_unit(const Decimal& first);
  void append_motion(const KeyRow& key, const Eigen::Quaterniond& orientation);
  [[nodiscard]] Expected<bool> append_time(const Decimal& time, std::string_view text, std::size_t line);
  [[nodiscard]] Expected<void> add_unposed(const KeyRow& key, const TextTable& table);
  [[nodiscard]] Expected<void> sort();
  [[nodiscard]] Expected<void> sort_unposed();

  KeyColumns columns_;
  ReadOptions options_;
  NewFrames frames_;
  KeyFile file_;
  std::optional<bool> has_iso_times_{};  // unknown before the first row
  std::size_t taken_ = 0;                // keys that are no longer in the file
  Decimal first_, latest_;               // times in the unit of the file
  double latest_seconds_ = 0.0;          // of `latest_` since the first [s]
  std::size_t latest_line_ = 0;          // of `latest_`
  EulerTurns turns_;                     // that the keys so far lose
  std::vector<Decimal> times_;           // of all rows, gathered only to be sorted
};

}}}  // namespace orispline::io
