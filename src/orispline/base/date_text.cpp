// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/date_text.hpp>

#include <chrono>
#include <cstdint>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double start_of_year_0 = -62'167'219'200.0, start_of_year_10000 = 253'402'300'800.0;

Decimal floor_of(const Decimal& number) {
  const Decimal nearest = number.rounded();
  return nearest > number ? nearest - Decimal::power_of_ten(0) : nearest;
}

}  // namespace

std::string date_text(const Decimal& seconds) {
  using namespace std::chrono;
  const Decimal whole = floor_of(seconds);
  const double size = whole.to_double();
  if (!(start_of_year_0 <= size && size < start_of_year_10000)) return seconds.to_string() + " s";
  const sys_seconds instant{std::chrono::seconds(static_cast<std::int64_t>(size))};
  const auto midnight = floor<days>(instant);
  const year_month_day date(midnight);
  const hh_mm_ss time(instant - midnight);
  const Decimal rest = seconds - whole;
  return formatted("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}{}", static_cast<int>(date.year()),
                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), time.hours().count(),
                   time.minutes().count(), time.seconds().count(),
                   rest == Decimal() ? "" : rest.to_string().substr(1));  // without the 0 before the point
}

}}  // namespace orispline
