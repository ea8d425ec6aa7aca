// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <orispline/base/decimal.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/io/clock.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// `week` and `day`, or a counter: `24bit`, `int16` and `uint16` in units of the column, `24bit*1us` in units of its
/// own. Nothing for other texts.
[[nodiscard]] ORISPLINE_EXPORT std::optional<ClockRound> clock_round_of(std::string_view text);

/// Counts on where a counter begins again, by the latest of its times: rows are less than half a round apart, and a row
/// may be late by as much.
class RoundClock {
 public:
  /// Of a round of that length, in the unit of the times.
  explicit RoundClock(const Decimal& length) : length_(length) {}

  /// Error (bad_data): times that lie farther apart than a round is long.
  [[nodiscard]] Expected<Decimal> counted_on(const Decimal& counter);
  /// Error (bad_argument, of `unwrap`): it never did.
  [[nodiscard]] Expected<void> check_came_round() const;

 private:
  Decimal length_, lowest_, highest_, before_;  // of all counters, and what the rounds before this one took
  std::optional<Decimal> latest_{};
};

}}}  // namespace orispline::io
