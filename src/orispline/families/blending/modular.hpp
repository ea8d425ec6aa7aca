// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// A number modulo a prime below 2^61.
template <std::uint64_t Prime>
class Residue {
 public:
  constexpr Residue() = default;
  constexpr explicit Residue(std::uint64_t value) : value_(value % Prime) {}

  [[nodiscard]] constexpr std::uint64_t value() const noexcept { return value_; }
  [[nodiscard]] constexpr Residue operator-() const noexcept { return Residue(value_ == 0 ? 0 : Prime - value_); }
  [[nodiscard]] constexpr Residue operator+(Residue other) const noexcept { return Residue(value_ + other.value_); }
  [[nodiscard]] constexpr Residue operator*(Residue other) const noexcept {
    __extension__ typedef unsigned __int128 Wide;
    return Residue(static_cast<std::uint64_t>(static_cast<Wide>(value_) * other.value_ % Prime));
  }
  /// 0 of 0.
  [[nodiscard]] constexpr Residue inverse() const noexcept {
    Residue result(1), square = *this;
    for (std::uint64_t exponent = Prime - 2; exponent > 0; exponent >>= 1, square = square * square)
      if (exponent & 1) result = result * square;
    return result;
  }
  bool operator==(const Residue&) const = default;

 private:
  std::uint64_t value_ = 0;
};

/// A fraction modulo two primes, where fractions are exact: an identity between polynomials with rational coefficients
/// of degrees far below 2^61 holds where it holds at random places, but for one chance in 10^17 in each field. After a
/// division by 0 it is undefined and equals nothing, as NaN does.
class Modular {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1, other_prime = (std::uint64_t{1} << 61) - 31;

  constexpr Modular() = default;
  constexpr explicit Modular(std::uint64_t value) : first_(value), second_(value) {}

  [[nodiscard]] constexpr std::uint64_t value() const noexcept { return first_.value(); }  ///< modulo `prime`
  [[nodiscard]] constexpr bool is_defined() const noexcept { return is_defined_; }
  /// Whether it can be divided by.
  [[nodiscard]] constexpr bool is_divisor() const noexcept {
    return is_defined_ && first_.value() != 0 && second_.value() != 0;
  }
  [[nodiscard]] constexpr Modular operator-() const noexcept { return {-first_, -second_, is_defined_}; }
  [[nodiscard]] constexpr Modular operator+(const Modular& other) const noexcept {
    return {first_ + other.first_, second_ + other.second_, is_defined_ && other.is_defined_};
  }
  [[nodiscard]] constexpr Modular operator-(const Modular& other) const noexcept { return *this + -other; }
  [[nodiscard]] constexpr Modular operator*(const Modular& other) const noexcept {
    return {first_ * other.first_, second_ * other.second_, is_defined_ && other.is_defined_};
  }
  [[nodiscard]] constexpr Modular operator/(const Modular& other) const noexcept {
    return {first_ * other.first_.inverse(), second_ * other.second_.inverse(), is_defined_ && other.is_divisor()};
  }
  [[nodiscard]] constexpr Modular power(std::uint64_t exponent) const noexcept {
    Modular result(1);
    for (Modular square = *this; exponent > 0; exponent >>= 1, square = square * square)
      if (exponent & 1) result = result * square;
    return result;
  }
  [[nodiscard]] constexpr bool operator==(const Modular& other) const noexcept {
    return is_defined_ && other.is_defined_ && first_ == other.first_ && second_ == other.second_;
  }

 private:
  using First = Residue<prime>;
  using Second = Residue<other_prime>;
  constexpr Modular(First first, Second second, bool is_defined)
      : first_(first), second_(second), is_defined_(is_defined) {}

  First first_;
  Second second_;
  bool is_defined_ = true;
};

/// The fraction of small numerator and denominator that it stands for, as text such as `-7/20`; nothing where it is
/// none.
[[nodiscard]] std::optional<std::string> fraction_text(Modular number);

}}}  // namespace orispline::blending
