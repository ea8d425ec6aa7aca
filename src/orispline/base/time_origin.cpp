// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <orispline/base/shortest_rest.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double split_unit =
    0x1p-20;  // [s] of which the higher half is a whole multiple, an exact decimal of 20 places
constexpr double largest_split = 0x1p+33;  // [s] such a multiple is a double up to here, with room to spare

constexpr auto decades = [] {
  std::array<Decade, highest_decade - lowest_decade + 1> all{};
  for (int exponent = lowest_decade; exponent <= highest_decade; ++exponent)
    all[static_cast<std::size_t>(exponent - lowest_decade)] = decade(exponent);
  return all;
}();

/// shortest_rest() of a number greater than 0; NaN where none of the decades has it.
double rest_of(double x) {
  constexpr double digits_of_bit = 0.30102999566398120;                        // log₁₀ 2
  int exponent = static_cast<int>(std::floor(std::ilogb(x) * digits_of_bit));  // that, or one more
  if (exponent < highest_decade && exponent >= lowest_decade - 1 && x >= least_of_decade(exponent + 1)) ++exponent;
  if (exponent < lowest_decade || exponent > highest_decade) return std::numeric_limits<double>::quiet_NaN();
  return shortest_rest(x, decades[static_cast<std::size_t>(exponent - lowest_decade)]);
}

}  // namespace

TimeOrigin::TimeOrigin(const Decimal& time) : time_(time) {
  const double nearest = time.to_double();
  if (!(std::abs(nearest) <= largest_split)) return;
  const double multiple = std::round(nearest / split_unit);
  const Decimal high = Decimal::from_double(multiple) * Decimal::from_double(split_unit);
  halves_ = Halves{multiple * split_unit, (time_ - high).to_double()};
}

double TimeOrigin::nearest_plus(double offset) const {
  if (time_ == Decimal()) return offset;
  if (halves_ && offset != 0.0) {
    const double rest = offset < 0.0 ? -rest_of(-offset) : rest_of(offset);
    const double sum = nearest_sum(halves_->high, halves_->low, offset, rest);
    if (!std::isnan(sum)) return sum;
  }
  return plus(offset).to_double();
}

}}  // namespace orispline
