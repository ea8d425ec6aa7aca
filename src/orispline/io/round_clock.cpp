// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/round_clock.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::array rounds_in_seconds{std::pair<std::string_view, double>{"week", 604800.0},
                                       std::pair<std::string_view, double>{"day", 86400.0}};
constexpr std::array ticks{std::pair<std::string_view, int>{"ms", -3}, std::pair<std::string_view, int>{"us", -6},
                           std::pair<std::string_view, int>{"ns", -9}, std::pair<std::string_view, int>{"s", 0}};
constexpr int most_bits = 64;

std::string_view without(std::string_view text, std::string_view beginning, std::string_view end) {
  if (text.size() <= beginning.size() + end.size() || !text.starts_with(beginning) || !text.ends_with(end)) return {};
  return text.substr(beginning.size(), text.size() - beginning.size() - end.size());
}

/// How many numbers a counter such as `24bit` or `int16` has.
std::optional<Decimal> numbers_of(std::string_view counter) {
  for (const auto& [beginning, end] : {std::pair("", "bit"), std::pair("uint", ""), std::pair("int", "")}) {
    const std::string_view digits = without(counter, beginning, end);
    int bits = 0;
    const auto [rest, status] = std::from_chars(digits.data(), digits.data() + digits.size(), bits);
    if (digits.empty() || status != std::errc() || rest != digits.data() + digits.size()) continue;
    if (bits < 1 || bits > most_bits) return std::nullopt;
    Decimal numbers = Decimal::power_of_ten(0);
    for (int bit = 0; bit < bits; ++bit) numbers = numbers + numbers;
    return numbers;
  }
  return std::nullopt;
}

/// The seconds of a tick such as `1us`.
std::optional<Decimal> seconds_of_tick(std::string_view tick) {
  for (const auto& [unit, exponent] : ticks) {
    if (!tick.ends_with(unit)) continue;
    const auto number = Decimal::parse(tick.substr(0, tick.size() - unit.size()));
    if (!number || *number <= Decimal()) return std::nullopt;
    return *number * Decimal::power_of_ten(exponent);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ClockRound> clock_round_of(std::string_view text) {
  for (const auto& [name, seconds] : rounds_in_seconds)
    if (text == name) return ClockRound{Decimal::from_double(seconds), true};
  const std::size_t times = text.find('*');
  const auto numbers = numbers_of(text.substr(0, times));
  if (!numbers || times == std::string_view::npos)
    return numbers.has_value() ? std::optional(ClockRound{*numbers, false}) : std::nullopt;
  const auto tick = seconds_of_tick(text.substr(times + 1));
  return tick ? std::optional(ClockRound{*numbers * *tick, true}) : std::nullopt;
}

Expected<Decimal> RoundClock::counted_on(const Decimal& counter) {
  lowest_ = latest_ ? std::min(lowest_, counter) : counter;
  highest_ = latest_ ? std::max(highest_, counter) : counter;
  if (highest_ - lowest_ >= length_)
    return failure(ErrorCode::bad_data,
                   formatted("found the times {} and {}, wanted all within one round of {}, as `unwrap` states it",
                             lowest_.to_string(), highest_.to_string(), length_.to_string()));
  Decimal time = counter + before_;
  if (!latest_) latest_ = time;
  const Decimal twice_ahead = (time - *latest_) + (time - *latest_);
  if (twice_ahead < -length_) {
    before_ = before_ + length_;
    time = time + length_;
  } else if (twice_ahead > length_ && before_ > Decimal()) {
    return time - length_;
  }
  latest_ = std::max(*latest_, time);
  return time;
}

Expected<void> RoundClock::check_came_round() const {
  if (before_ > Decimal()) return {};
  return bad_option("unwrap", formatted("found times from {} to {}, which never come round at {}; wanted a clock that "
                                        "does, or no such option",
                                        lowest_.to_string(), highest_.to_string(), length_.to_string()));
}

}}}  // namespace orispline::io
