// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/time_column.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/column_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// Suffix of time columns: value · factor · 10^exponent is in seconds.
struct TimeSuffix {
  std::string_view suffix;
  int exponent = 0;
  double factor = 1.0;

  [[nodiscard]] TimeUnit unit() const {
    return {Decimal::from_double(factor) * Decimal::power_of_ten(exponent), !suffix.empty()};
  }
};

constexpr double week = 604800.0;

constexpr std::array<std::string_view, 4> time_names{time_name, "time", "timestamp", "stamp"};
constexpr std::array suffixes{TimeSuffix{""},           TimeSuffix{"_s"},           TimeSuffix{"_sec"},
                              TimeSuffix{"_secs"},      TimeSuffix{"_seconds"},     TimeSuffix{"_ms", -3},
                              TimeSuffix{"_msec", -3},  TimeSuffix{"_us", -6},      TimeSuffix{"_usec", -6},
                              TimeSuffix{"_ns", -9},    TimeSuffix{"_nsec", -9},    TimeSuffix{"_nsecs", -9},
                              TimeSuffix{"_nanos", -9}, TimeSuffix{"_nanosec", -9}, TimeSuffix{"_nanoseconds", -9}};
/// Units that are names of columns themselves.
constexpr std::array bare_units{TimeSuffix{"sec"},       TimeSuffix{"secs"},       TimeSuffix{"seconds"},
                                TimeSuffix{"msec", -3},  TimeSuffix{"usec", -6},   TimeSuffix{"nsec", -9},
                                TimeSuffix{"nsecs", -9}, TimeSuffix{"nanosec", -9}};
/// Parts of the time that satellites give, which names that a caller states may end in.
constexpr std::array parts_of_time{TimeSuffix{"week", 0, week}, TimeSuffix{"weeks", 0, week}, TimeSuffix{"tow"},
                                   TimeSuffix{"itow", -3}};

constexpr std::array<std::string_view, 2> frame_names{"frame", "frames"};

/// A time of today in a unit, and what people call that.
struct SizeOfTime {
  int from_digits;  // 10^that and more are of this unit
  int exponent;
  std::string_view name;
};
constexpr std::array sizes{SizeOfTime{17, -9, "nanoseconds"}, SizeOfTime{14, -6, "microseconds"},
                           SizeOfTime{11, -3, "milliseconds"}};

}  // namespace

TimeUnit time_unit_at_end_of(std::string_view name) {
  for (const TimeSuffix& bare : bare_units)
    if (name == bare.suffix) return bare.unit();
  const TimeSuffix stated = unit_of<TimeSuffix>(name, suffixes);
  if (!stated.suffix.empty()) return stated.unit();
  for (const TimeSuffix& part : parts_of_time)
    if (name.ends_with(part.suffix) &&
        (name.size() == part.suffix.size() || name[name.size() - part.suffix.size() - 1] == '_'))
      return part.unit();
  return stated.unit();
}

std::optional<TimeUnit> time_unit_of(std::string_view name) {
  if (std::ranges::find(bare_units, name, &TimeSuffix::suffix) != bare_units.end()) return time_unit_at_end_of(name);
  for (const std::string_view base : time_names)
    if (is_with_unit<TimeSuffix>(name, base, suffixes)) return time_unit_at_end_of(name);
  return std::nullopt;
}

bool counts_frames(std::string_view name) noexcept { return std::ranges::find(frame_names, name) != frame_names.end(); }

Expected<Fraction> seconds_per_frame(std::string_view column, const Clock& clock) {
  if (clock.frames_per_second) return clock.frames_per_second->inverse();
  return mended_by("fps",
                   formatted("the column {} counts frames, wanted how many there are in a second", in_quotes(column)));
}

std::optional<TimeUnitGuess> time_unit_by_size(const Decimal& first) {
  const Decimal size = first < Decimal() ? Decimal() - first : first;
  for (const auto& [digits, exponent, name] : sizes)
    if (size >= Decimal::power_of_ten(digits))
      return TimeUnitGuess{
          Decimal::power_of_ten(exponent),
          {.code = "time_unit_by_size",
           .message = formatted("the times are taken as {}, for the first one is {}; set `time_scale` if they are not",
                                name, first.to_string())}};
  return std::nullopt;
}

}}}  // namespace orispline::io
