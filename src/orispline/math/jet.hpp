// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Truncated Taylor number in one variable: a value with its first N derivatives.
///
/// `c[k]` is the k-th derivative divided by k!. Arithmetic is that of power series cut after order N, so a formula
/// written once over a Number yields its exact derivatives when it is fed `Jet::variable(t)`.
///
/// The orders are packs, not loops: with constant indices the coefficients are in registers from the start. A loop
/// keeps them in memory, where GCC 12 writes one at a time and reads two; the processor waits at each such read, and
/// the rates of a curve take four times as long.
template <class T, int N>
struct Jet {
  static constexpr std::size_t size = static_cast<std::size_t>(N) + 1;
  std::array<T, size> c{};

  constexpr Jet() = default;
  constexpr Jet(T value) { c[0] = value; }  // NOLINT: a plain number is a constant
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) constexpr Jet(U value)
      : Jet(static_cast<T>(value)) {}  // NOLINT

  /// The variable itself at `value`: derivative 1, higher derivatives 0.
  [[nodiscard]] static constexpr Jet variable(T value) {
    Jet j(value);
    if constexpr (N > 0) j.c[1] = T(1);
    return j;
  }

  /// k-th derivative, not divided by k!.
  [[nodiscard]] constexpr T derivative(std::size_t k) const {
    T d = c[k];
    for (std::size_t i = 2; i <= k; ++i) d = d * T(static_cast<double>(i));
    return d;
  }

  constexpr Jet& operator+=(const Jet& b) {
    return each(b, Orders{}, [](T& x, const T& y) { x += y; });
  }
  constexpr Jet& operator-=(const Jet& b) {
    return each(b, Orders{}, [](T& x, const T& y) { x -= y; });
  }
  constexpr Jet& operator*=(const Jet& b) { return *this = *this * b; }
  constexpr Jet& operator/=(const Jet& b) { return *this = *this / b; }

  friend constexpr Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend constexpr Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend constexpr Jet operator-(Jet a) {
    return a.each(Orders{}, [](T& x) { x = -x; });
  }
  [[gnu::always_inline]] friend constexpr Jet operator*(const Jet& a, const Jet& b) { return product(a, b, Orders{}); }
  friend constexpr Jet operator*(Jet a, T s) {
    return a.each(Orders{}, [&s](T& x) { x *= s; });
  }
  friend constexpr Jet operator*(T s, const Jet& a) { return a * s; }
  friend constexpr Jet operator/(Jet a, T s) {
    return a.each(Orders{}, [&s](T& x) { x /= s; });
  }
  // In a jet of jets a plain number scales every coefficient as well.
  friend constexpr Jet operator*(Jet a, Plain<T> s) requires(!std::is_same_v<Plain<T>, T>) {
    return a.each(Orders{}, [s](T& x) { x = x * s; });
  }
  friend constexpr Jet operator*(Plain<T> s, const Jet& a) requires(!std::is_same_v<Plain<T>, T>) { return a * s; }
  friend constexpr Jet operator/(Jet a, Plain<T> s) requires(!std::is_same_v<Plain<T>, T>) {
    return a.each(Orders{}, [s](T& x) { x = x / s; });
  }
  friend constexpr Jet operator/(const Jet& a, const Jet& b) { return quotient(a, b, Orders{}); }
  friend constexpr bool operator==(const Jet&, const Jet&) = default;

 private:
  using Orders = std::make_index_sequence<size>;

  template <std::size_t... K, class F>
  constexpr Jet& each(std::index_sequence<K...>, F change) {
    (change(c[K]), ...);
    return *this;
  }
  template <std::size_t... K, class F>
  constexpr Jet& each(const Jet& b, std::index_sequence<K...>, F change) {
    (change(c[K], b.c[K]), ...);
    return *this;
  }

  // Always inlined: in a source with as many curves as the registry GCC calls products, which costs a fifth more.
  template <std::size_t... K>
  [[gnu::always_inline]] static constexpr Jet product(const Jet& a, const Jet& b, std::index_sequence<K...>) {
    Jet r;
    ((r.c[K] = product_term<K>(a, b, std::make_index_sequence<K + 1>{})), ...);
    return r;
  }
  template <std::size_t K, std::size_t... I>
  [[gnu::always_inline]] static constexpr T product_term(const Jet& a, const Jet& b, std::index_sequence<I...>) {
    return (T(0) + ... + (a.c[I] * b.c[K - I]));
  }

  /// Solves product(r, b) = a for one term of r after the other.
  template <std::size_t... K>
  static constexpr Jet quotient(const Jet& a, const Jet& b, std::index_sequence<K...>) {
    Jet r;
    ((r.c[K] = (rest<K>(a, r, b, std::make_index_sequence<K>{}) / b.c[0])), ...);
    return r;
  }
  template <std::size_t K, std::size_t... I>
  static constexpr T rest(const Jet& a, const Jet& r, const Jet& b, std::index_sequence<I...>) {
    return (a.c[K] - ... - (r.c[I] * b.c[K - I]));
  }
};

template <class T, int N>
[[nodiscard]] constexpr auto value_of(const Jet<T, N>& x) noexcept {
  return value_of(x.c[0]);
}

/// Square root; the value must be positive.
template <class T, int N>
[[nodiscard]] Jet<T, N> sqrt_of(const Jet<T, N>& a) noexcept {
  Jet<T, N> r(sqrt_of(a.c[0]));
  for (std::size_t k = 1; k < a.size; ++k) {
    T x = a.c[k];
    for (std::size_t i = 1; i < k; ++i) x -= r.c[i] * r.c[k - i];
    r.c[k] = x / (r.c[0] + r.c[0]);
  }
  return r;
}

template <class T, int N>
void sin_cos(const Jet<T, N>& x, Jet<T, N>& sine, Jet<T, N>& cosine) noexcept {
  sin_cos(x.c[0], sine.c[0], cosine.c[0]);
  for (std::size_t k = 1; k < x.size; ++k) {
    T s(0), c(0);
    for (std::size_t i = 1; i <= k; ++i) {
      const T dx = x.c[i] * T(static_cast<double>(i));
      s += dx * cosine.c[k - i];
      c -= dx * sine.c[k - i];
    }
    sine.c[k] = s / T(static_cast<double>(k));
    cosine.c[k] = c / T(static_cast<double>(k));
  }
}

/// Angle of the point (x, y): its derivative is (x y' - y x') / (x² + y²).
template <class T, int N>
[[nodiscard]] Jet<T, N> atan2_of(const Jet<T, N>& y, const Jet<T, N>& x) noexcept {
  const Jet<T, N> r2 = x * x + y * y;
  Jet<T, N> angle(atan2_of(y.c[0], x.c[0]));
  for (std::size_t k = 1; k < y.size; ++k) {
    T d(0);  // coefficient k-1 of (x y' - y x') less what the lower orders of angle' already explain
    for (std::size_t i = 1; i <= k; ++i) d += T(static_cast<double>(i)) * (x.c[k - i] * y.c[i] - y.c[k - i] * x.c[i]);
    for (std::size_t i = 1; i < k; ++i) d -= T(static_cast<double>(i)) * angle.c[i] * r2.c[k - i];
    angle.c[k] = d / (T(static_cast<double>(k)) * r2.c[0]);
  }
  return angle;
}

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
