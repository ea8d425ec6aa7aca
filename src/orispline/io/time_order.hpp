// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// So many rows that rise from one which goes back in time are a recording of their own; fewer are disorder.
inline constexpr std::size_t fewest_of_session = 3;

/// Tells rows in disorder from those of a further recording, by their times in the order of the file.
class ORISPLINE_EXPORT TimeOrder {
 public:
  enum class Row {
    on_time,
    late,   ///< after a row of later time
    begins  ///< a further recording began, `late_rows()` rows ago
  };

  [[nodiscard]] Row add(const Decimal& time);

  /// Rows up to the last one that rise from one which went back.
  [[nodiscard]] std::size_t late_rows() const noexcept { return rows_; }

 private:
  std::optional<Decimal> latest_{}, late_{};  // of the recording, and of the last row where that is late
  std::size_t rising_ = 0, rows_ = 0;         // different times of the late rows, and all of them
};

/// The first row of each recording.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::size_t> session_starts(std::span<const Decimal> times);

/// Whether so many rows that begin anew so often may be sorted: they are one recording, or in such disorder that hardly
/// three rise in succession. Else sorting mixes recordings, or puts what a clock counts after it came round first.
[[nodiscard]] ORISPLINE_EXPORT bool may_be_sorted(std::size_t rows, std::size_t sessions) noexcept;

/// Whether a single time of 0 behind so many others, which go from the first to the last, is none of theirs: 0 was
/// there before, or is many of their steps away.
[[nodiscard]] ORISPLINE_EXPORT bool is_far_from_zero(const Decimal& first, const Decimal& last, std::size_t count);

/// Rows with a time of 0 between rows of other times, which are invalid time stamps: not those that begin a recording.
[[nodiscard]] ORISPLINE_EXPORT std::vector<bool> zero_stamps(std::span<const Decimal> times);

/// Whether a stamp that has come twice is one of a clock too coarse for the rows, by the times of some rows after it.
[[nodiscard]] ORISPLINE_EXPORT bool repeat_in_runs(const Decimal& twice, std::span<const Decimal> after);

}}}  // namespace orispline::io
