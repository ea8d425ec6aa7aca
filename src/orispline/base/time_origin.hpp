// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// An exact time that doubles are counted from.
class ORISPLINE_EXPORT TimeOrigin {
 public:
  explicit TimeOrigin(const Decimal& time);

  [[nodiscard]] const Decimal& time() const noexcept { return time_; }
  /// The exact sum with the shortest decimal of a finite offset.
  [[nodiscard]] Decimal plus(double offset) const { return time_ + Decimal::from_double(offset); }
  /// The double nearest to that sum, mostly without forming it.
  [[nodiscard]] double nearest_plus(double offset) const;

 private:
  Decimal time_;
  bool is_split_;  // whether the time is high_ + low_, to 2^-53 |low_|
  double high_, low_ = 0.0;
};

}}  // namespace orispline
