// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <orispline/base/decimal.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/io/clock.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The canonical name of the column of times.
inline constexpr std::string_view time_name = "t";

/// A unit of times and whether the name of the column states it.
struct TimeUnit {
  Decimal seconds = Decimal::power_of_ten(0);
  bool is_stated = false;
};

/// Unit of a column that is named like a time; nothing for other names.
[[nodiscard]] ORISPLINE_EXPORT std::optional<TimeUnit> time_unit_of(std::string_view name);

/// Whether a column is named like a number of frames: read as times where no other column is one.
[[nodiscard]] ORISPLINE_EXPORT bool counts_frames(std::string_view name) noexcept;

/// Seconds per frame. Error (bad_data): nobody says how many there are in a second.
[[nodiscard]] ORISPLINE_EXPORT Expected<Fraction> seconds_per_frame(std::string_view column, const Clock& clock);

/// The unit that the end of any name states, such as one that was mapped; without one they are seconds.
[[nodiscard]] ORISPLINE_EXPORT TimeUnit time_unit_at_end_of(std::string_view name);

/// The unit of times whose unit is not stated, by the size of the first one: clocks count from 1970, so that 1e11 and
/// more are no seconds.
struct TimeUnitGuess {
  Decimal seconds;
  Warning warning;  ///< `time_unit_by_size`
};
[[nodiscard]] ORISPLINE_EXPORT std::optional<TimeUnitGuess> time_unit_by_size(const Decimal& first);

}}}  // namespace orispline::io
