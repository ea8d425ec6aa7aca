// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include <orispline/families/blending/expression.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// A double with a bound of its error, which every operation carries on: where it is farther from 0 than that, the
/// exact number is not 0.
class Rounded {
 public:
  Rounded() = default;
  /// A number that was rounded once.
  explicit Rounded(double value) : Rounded(value, 0.0) {}
  explicit Rounded(const Literal& literal) : Rounded(literal.real) {}

  [[nodiscard]] double value() const noexcept { return value_; }
  /// Whether the exact number is not 0, for certain. What overflowed tells nothing.
  [[nodiscard]] bool is_not_zero() const noexcept { return std::isfinite(value_) && std::abs(value_) > error_; }

  [[nodiscard]] Rounded operator-() const noexcept { return {-value_, error_}; }
  [[nodiscard]] Rounded operator+(const Rounded& b) const noexcept { return {value_ + b.value_, error_ + b.error_}; }
  [[nodiscard]] Rounded operator-(const Rounded& b) const noexcept { return *this + -b; }
  [[nodiscard]] Rounded operator*(const Rounded& b) const noexcept {
    return {value_ * b.value_, std::abs(value_) * b.error_ + error_ * (std::abs(b.value_) + b.error_)};
  }
  [[nodiscard]] Rounded operator/(const Rounded& b) const noexcept {
    const double quotient = value_ / b.value_, least = std::abs(b.value_) - b.error_;
    return {quotient, least > 0.0 ? (error_ + std::abs(quotient) * b.error_) / least : infinite};
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  /// An error with the rounding of the value and of the error itself.
  Rounded(double value, double error)
      : value_(value),
        error_(1.001 * error + std::numeric_limits<double>::epsilon() * std::abs(value) +
               std::numeric_limits<double>::min()) {}

  double value_ = 0.0, error_ = 0.0;
};

}}}  // namespace orispline::blending
