// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// A number of the field of the prime 2^61 - 1. Fractions are exact there, so that an identity between polynomials with
/// rational coefficients can be decided: it holds where it holds at random places, but for one chance in 10^17.
class Modular {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  constexpr Modular() = default;
  constexpr explicit Modular(std::uint64_t value) : value_(value % prime) {}

  [[nodiscard]] constexpr std::uint64_t value() const noexcept { return value_; }
  [[nodiscard]] constexpr Modular operator-() const noexcept { return Modular(value_ == 0 ? 0 : prime - value_); }
  [[nodiscard]] constexpr Modular operator+(Modular other) const noexcept { return Modular(value_ + other.value_); }
  [[nodiscard]] constexpr Modular operator-(Modular other) const noexcept { return *this + -other; }
  [[nodiscard]] constexpr Modular operator*(Modular other) const noexcept {
    __extension__ typedef unsigned __int128 Wide;
    return Modular(static_cast<std::uint64_t>(static_cast<Wide>(value_) * other.value_ % prime));
  }
  /// By zero it is 0, which callers exclude.
  [[nodiscard]] constexpr Modular operator/(Modular other) const noexcept { return *this * other.power(prime - 2); }
  [[nodiscard]] constexpr Modular power(std::uint64_t exponent) const noexcept {
    Modular result(1);
    for (Modular square = *this; exponent > 0; exponent >>= 1, square = square * square)
      if (exponent & 1) result = result * square;
    return result;
  }
  bool operator==(const Modular&) const = default;

 private:
  std::uint64_t value_ = 0;
};

/// The fraction of small numerator and denominator that it stands for, as text such as `-7/20`; nothing where it is
/// none.
[[nodiscard]] std::optional<std::string> fraction_text(Modular number);

}}}  // namespace orispline::blending
