// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double split_unit = 0x1p-20;     // [s] of which `high_` is a whole multiple, an exact decimal of 20 places
constexpr double largest_split = 0x1p+33;  // [s] such a multiple is a double up to here, with room to spare

}  // namespace

TimeOrigin::TimeOrigin(const Decimal& time) : time_(time), is_split_(false), high_(time.to_double()) {
  if (!(std::abs(high_) <= largest_split)) return;
  const double multiple = std::round(high_ / split_unit);
  high_ = multiple * split_unit;
  low_ = (time_ - Decimal::from_double(multiple) * Decimal::from_double(split_unit)).to_double();
  is_split_ = true;
}

double TimeOrigin::nearest_plus(double offset) const {
  if (time_ == Decimal()) return offset;
  if (is_split_) {
    // Knuth's sum with its error; then the sum is sure where all that it may be rounds to the same double.
    const double sum = high_ + offset, part = sum - high_;
    const double rest = ((high_ - (sum - part)) + (offset - part)) + low_;
    const double doubt = 0x1p-52 * std::abs(offset) + 0x1p-51 * (std::abs(rest) + std::abs(low_));
    const double least = sum + (rest - doubt), most = sum + (rest + doubt);
    if (least == most) return least;
  }
  return plus(offset).to_double();
}

}}  // namespace orispline
