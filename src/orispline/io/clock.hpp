// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// After how much a counter comes round and begins again.
struct ClockRound {
  Decimal length{};
  bool is_in_seconds = false;  ///< else in units of the column of times
};

/// What times that are no numbers of seconds are counted by.
struct Clock {
  /// The instant that counts as 0 s, for times of ISO 8601: [s] since 1970-01-01T00:00:00Z.
  Decimal zero{};
  /// Of columns and times that count frames; greater than 0.
  std::optional<Fraction> frames_per_second{};
  /// Of columns whose counter comes round, which is counted on.
  std::optional<ClockRound> round{};
};

/// A time [s] as people type it: `2.5`, `1/24`, `12f` for a frame, `2024-02-29T12:30:00Z`.
///
/// Errors (bad_data): none of these; a frame where nobody says how many there are in a second.
[[nodiscard]] ORISPLINE_EXPORT Expected<Decimal> time_in(std::string_view text, const Clock& clock);

/// Whether a text begins as a date of ISO 8601 does, which no number does: four digits and a dash.
[[nodiscard]] ORISPLINE_EXPORT bool looks_like_iso_time(std::string_view text) noexcept;

/// Seconds since 1970-01-01T00:00:00 of a time of ISO 8601, with all of its decimals: `2024-02-29T12:30:00.25Z`, with
/// the day of the year as in CCSDS files `2024-060T12:30:00.25`, a blank or `t` in place of `T`, without seconds, or
/// the date alone. `Z`, an offset such as `+02:00`, or nothing, which is read as UTC.
///
/// UTC as it is written: every day has 86400 seconds, no leap seconds are counted, and 23:59:60 is the first instant of
/// the next day. Error: bad_data.
[[nodiscard]] ORISPLINE_EXPORT Expected<Decimal> parse_iso_time(std::string_view text);

}}}  // namespace orispline::io
