// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include <orispline/math/jet.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A value with its first derivatives in N directions at once: a dual number with N infinitesimal parts.
///
/// One pass through a formula over a Number yields a gradient of N entries, while a `Jet` yields one entry of it with
/// the higher orders.
template <std::size_t N>
struct Dual {
  static constexpr std::size_t directions = N;
  double value = 0.0;
  std::array<double, N> slope{};

  constexpr Dual() = default;
  constexpr Dual(double number) : value(number) {}  // NOLINT: a plain number is a constant

  /// The variable of one direction, at `value`.
  [[nodiscard]] static constexpr Dual variable(double value, std::size_t direction) {
    Dual x(value);
    x.slope[direction] = 1.0;
    return x;
  }

  constexpr Dual& operator+=(const Dual& b) {
    value += b.value;
    for (std::size_t k = 0; k < N; ++k) slope[k] += b.slope[k];
    return *this;
  }
  constexpr Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (std::size_t k = 0; k < N; ++k) slope[k] -= b.slope[k];
    return *this;
  }
  constexpr Dual& operator*=(double s) {
    value *= s;
    for (std::size_t k = 0; k < N; ++k) slope[k] *= s;
    return *this;
  }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend constexpr Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend constexpr Dual operator-(Dual a) { return a *= -1.0; }
  friend constexpr Dual operator*(Dual a, double s) { return a *= s; }
  friend constexpr Dual operator*(double s, Dual a) { return a *= s; }
  friend constexpr Dual operator/(Dual a, double s) { return a *= 1.0 / s; }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return combined(a.value * b.value, b.value, a, a.value, b);
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return combined(quotient, 1.0 / b.value, a, -quotient / b.value, b);
  }
  friend constexpr bool operator==(const Dual&, const Dual&) = default;

  /// A function of two numbers, with its derivatives da and db by them.
  [[nodiscard]] static constexpr Dual combined(double value, double da, const Dual& a, double db, const Dual& b) {
    Dual r(value);
    for (std::size_t k = 0; k < N; ++k) r.slope[k] = da * a.slope[k] + db * b.slope[k];
    return r;
  }

  /// The chain rule: a function of one number x, which is given as a series about the value of x.
  [[nodiscard]] static constexpr Dual chained(const Jet<double, 1>& function, const Dual& x) {
    Dual r(function.c[0]);
    for (std::size_t k = 0; k < N; ++k) r.slope[k] = function.c[1] * x.slope[k];
    return r;
  }
};

template <std::size_t N>
inline constexpr bool is_number<Dual<N>> = true;
template <std::size_t N>
struct PlainOf<Dual<N>> {
  using type = double;
};

template <std::size_t N>
[[nodiscard]] constexpr double value_of(const Dual<N>& x) noexcept {
  return x.value;
}

/// Square root; the value must be positive.
template <std::size_t N>
[[nodiscard]] Dual<N> sqrt_of(const Dual<N>& x) noexcept {
  return Dual<N>::chained(sqrt_of(Jet<double, 1>::variable(x.value)), x);
}

template <std::size_t N>
void sin_cos(const Dual<N>& x, Dual<N>& sine, Dual<N>& cosine) noexcept {
  Jet<double, 1> s, c;
  sin_cos(Jet<double, 1>::variable(x.value), s, c);
  sine = Dual<N>::chained(s, x);
  cosine = Dual<N>::chained(c, x);
}

/// Angle of the point (x, y).
template <std::size_t N>
[[nodiscard]] Dual<N> atan2_of(const Dual<N>& y, const Dual<N>& x) noexcept {
  const double r2 = x.value * x.value + y.value * y.value;
  return Dual<N>::combined(atan2_of(y.value, x.value), x.value / r2, y, -y.value / r2, x);
}

}}  // namespace orispline

namespace Eigen {

template <std::size_t N>
struct NumTraits<orispline::Dual<N>> : NumTraits<double> {
  using Real = orispline::Dual<N>;
  using NonInteger = orispline::Dual<N>;
  using Nested = orispline::Dual<N>;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = static_cast<int>(N) + 1,
    AddCost = static_cast<int>(N) + 1,
    MulCost = 3 * static_cast<int>(N) + 1
  };
};

// Plain matrices and vectors with those of duals: a constant scales a dual without a product of duals.
template <std::size_t N, class Operation>
struct ScalarBinaryOpTraits<orispline::Dual<N>, double, Operation> {
  using ReturnType = orispline::Dual<N>;
};
template <std::size_t N, class Operation>
struct ScalarBinaryOpTraits<double, orispline::Dual<N>, Operation> {
  using ReturnType = orispline::Dual<N>;
};

}  // namespace Eigen
