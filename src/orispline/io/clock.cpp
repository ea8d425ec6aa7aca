// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/clock.hpp>

#include <chrono>
#include <optional>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr int seconds_of_minute = 60, minutes_of_hour = 60, hours_of_day = 24;

bool is_digit(char c) noexcept { return '0' <= c && c <= '9'; }

Decimal whole_decimal(std::int64_t whole) { return Decimal::from_double(static_cast<double>(whole)); }

/// Reads the parts of a time from the front of a text; whatever is not as it should be makes the whole wrong.
class TimeScanner {
 public:
  explicit TimeScanner(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool is_right() const noexcept { return is_right_ && rest_.empty(); }
  [[nodiscard]] bool done() const noexcept { return rest_.empty(); }
  bool take(std::string_view any) {
    if (rest_.empty() || any.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) { is_right_ = take(std::string_view(&c, 1)) && is_right_; }
  void require(bool condition) { is_right_ = condition && is_right_; }
  [[nodiscard]] std::size_t leading_digits() const noexcept {
    std::size_t count = 0;
    while (count < rest_.size() && is_digit(rest_[count])) ++count;
    return count;
  }
  /// A whole number of so many digits.
  int number(std::size_t digits) {
    if (leading_digits() < digits) return is_right_ = false, 0;
    int value = 0;
    for (const char c : rest_.substr(0, digits)) value = 10 * value + (c - '0');
    rest_.remove_prefix(digits);
    return value;
  }
  /// `05`, `05.25`
  Decimal seconds() {
    const std::string_view all = rest_;
    static_cast<void>(number(2));
    if (take(".")) {
      is_right_ = leading_digits() > 0 && is_right_;
      rest_.remove_prefix(leading_digits());
    }
    const auto value = Decimal::parse(all.substr(0, all.size() - rest_.size()));
    is_right_ = value.has_value() && is_right_;
    return value.value_or(Decimal());
  }

 private:
  std::string_view rest_;
  bool is_right_ = true;
};

/// Days since 1970-01-01.
std::int64_t days(TimeScanner& scanner) {
  using namespace std::chrono;
  const year in{scanner.number(4)};
  scanner.expect('-');
  if (scanner.leading_digits() >= 3) {
    const int day_of_year = scanner.number(3);
    scanner.require(1 <= day_of_year && day_of_year <= (in.is_leap() ? 366 : 365));
    return sys_days(in / January / 1).time_since_epoch().count() + day_of_year - 1;
  }
  const month of{static_cast<unsigned>(scanner.number(2))};
  scanner.expect('-');
  const year_month_day date = in / of / day{static_cast<unsigned>(scanner.number(2))};
  scanner.require(date.ok());
  return date.ok() ? sys_days(date).time_since_epoch().count() : 0;
}

/// Minutes that the clock is ahead of UTC.
int offset(TimeScanner& scanner) {
  if (scanner.done() || scanner.take("Zz")) return 0;
  const bool ahead = scanner.take("+");
  if (!ahead) scanner.expect('-');
  const int hours = scanner.number(2);
  static_cast<void>(scanner.take(":"));
  const int minutes = scanner.done() ? 0 : scanner.number(2);
  scanner.require(hours < hours_of_day && minutes < minutes_of_hour);
  const int total = hours * minutes_of_hour + minutes;
  return ahead ? total : -total;
}

std::optional<Decimal> seconds_of(std::string_view text) {
  TimeScanner scanner(text);
  const std::int64_t day = days(scanner);
  if (scanner.done())
    return scanner.is_right() ? std::optional(whole_decimal(day * hours_of_day * minutes_of_hour * seconds_of_minute))
                              : std::nullopt;
  scanner.require(scanner.take("Tt "));
  const int hour = scanner.number(2);
  scanner.expect(':');
  const int minute = scanner.number(2);
  const Decimal second = scanner.take(":") ? scanner.seconds() : Decimal();
  const int ahead = offset(scanner);
  const bool may_leap = minute == minutes_of_hour - 1;
  scanner.require(minute < minutes_of_hour && second < whole_decimal(seconds_of_minute + (may_leap ? 1 : 0)));
  scanner.require(hour < hours_of_day || (hour == hours_of_day && minute == 0 && second == Decimal()));
  if (!scanner.is_right()) return std::nullopt;
  const std::int64_t minutes = (day * hours_of_day + hour) * minutes_of_hour + minute - ahead;
  return whole_decimal(minutes * seconds_of_minute) + second;
}

constexpr char frame_mark = 'f';

Expected<Decimal> time_of_frame(std::string_view text, const Clock& clock) {
  const auto frame = Decimal::parse(text.substr(0, text.size() - 1));
  if (!frame)
    return failure(ErrorCode::bad_data,
                   formatted("found {}, wanted a frame such as 12{}", in_quotes(text), frame_mark));
  if (!clock.frames_per_second)
    return mended_by("fps", formatted("found the frame {}, wanted the frames per second as well", in_quotes(text)));
  return clock.frames_per_second->inverse().time_of(*frame);
}

}  // namespace

bool looks_like_iso_time(std::string_view text) noexcept {
  constexpr std::size_t digits_of_year = 4;
  if (text.size() <= digits_of_year || text[digits_of_year] != '-') return false;
  for (const char c : text.substr(0, digits_of_year))
    if (!is_digit(c)) return false;
  return true;
}

Expected<Decimal> parse_iso_time(std::string_view text) {
  if (const auto seconds = seconds_of(text)) return *seconds;
  return failure(ErrorCode::bad_data,
                 formatted("found {}, wanted a time of ISO 8601 such as 2024-02-29T12:30:00.25Z", in_quotes(text)));
}

Expected<Decimal> time_in(std::string_view text, const Clock& clock) {
  if (looks_like_iso_time(text))
    return parse_iso_time(text).map([&](const Decimal& time) { return time - clock.zero; });
  if (text.ends_with(frame_mark)) return time_of_frame(text, clock);
  if (const auto seconds = Fraction::parse(text)) return seconds->time_of(Decimal::power_of_ten(0));
  return failure(ErrorCode::bad_data,
                 formatted("found {}, wanted a number of seconds, a fraction such as 1/24, a frame "
                           "such as 12{}, or a time such as 2024-02-29T12:30:00Z",
                           in_quotes(text), frame_mark));
}

}}}  // namespace orispline::io
