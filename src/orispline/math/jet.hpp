// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/math/number.hpp>

namespace orispline {

/// Truncated Taylor number in one variable: a value with its first N derivatives.
///
/// `c[k]` is the k-th derivative divided by k!. Arithmetic is that of power series cut after order N, so a formula
/// written once over a Number yields its exact derivatives when it is fed `Jet::variable(t)`.
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
    for (std::size_t k = 0; k < size; ++k) c[k] += b.c[k];
    return *this;
  }
  constexpr Jet& operator-=(const Jet& b) {
    for (std::size_t k = 0; k < size; ++k) c[k] -= b.c[k];
    return *this;
  }
  constexpr Jet& operator*=(const Jet& b) { return *this = *this * b; }
  constexpr Jet& operator/=(const Jet& b) { return *this = *this / b; }

  friend constexpr Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend constexpr Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend constexpr Jet operator-(Jet a) {
    for (T& x : a.c) x = -x;
    return a;
  }
  friend constexpr Jet operator*(const Jet& a, const Jet& b) {
    Jet r;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; i + j < size; ++j) r.c[i + j] += a.c[i] * b.c[j];
    return r;
  }
  friend constexpr Jet operator*(Jet a, T s) {
    for (T& x : a.c) x *= s;
    return a;
  }
  friend constexpr Jet operator*(T s, const Jet& a) { return a * s; }
  friend constexpr Jet operator/(Jet a, T s) {
    for (T& x : a.c) x /= s;
    return a;
  }
  // In a jet of jets a plain number scales every coefficient as well.
  friend constexpr Jet operator*(Jet a, Plain<T> s) requires(!std::is_same_v<Plain<T>, T>) {
    for (T& x : a.c) x = x * s;
    return a;
  }
  friend constexpr Jet operator*(Plain<T> s, const Jet& a) requires(!std::is_same_v<Plain<T>, T>) { return a * s; }
  friend constexpr Jet operator/(Jet a, Plain<T> s) requires(!std::is_same_v<Plain<T>, T>) {
    for (T& x : a.c) x = x / s;
    return a;
  }
  friend constexpr Jet operator/(const Jet& a, const Jet& b) {
    Jet r;
    for (std::size_t k = 0; k < size; ++k) {
      T x = a.c[k];
      for (std::size_t i = 0; i < k; ++i) x -= r.c[i] * b.c[k - i];
      r.c[k] = x / b.c[0];
    }
    return r;
  }
  friend constexpr bool operator==(const Jet&, const Jet&) = default;
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

}  // namespace orispline
