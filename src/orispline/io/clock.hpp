// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <orispline/base/fraction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What times that are no numbers of seconds are counted by.
struct Clock {
  /// The instant that counts as 0 s, for times of ISO 8601: [s] since 1970-01-01T00:00:00Z.
  Decimal zero{};
  /// Of columns and times that count frames; greater than 0.
  std::optional<Fraction> frames_per_second{};
};

/// A time [s] as people type it: `2.5`, `1/24`, `12f` for a frame, `2024-02-29T12:30:00Z`.
///
/// Errors (bad_data): none of these; a frame where nobody says how many there are in a second.
[[nodiscard]] ORISPLINE_EXPORT Expected<Decimal> time_in(std::string_view text, const Clock& clock);

}}}  // namespace orispline::io
