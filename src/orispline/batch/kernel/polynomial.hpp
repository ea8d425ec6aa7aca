// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include <orispline/base/abi.hpp>

// Polynomials for the kernel's loops, over numbers or over lanes. In an anonymous namespace, so that every instruction
// set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

/// Four numbers side by side, which add and multiply as one.
template <class T>
struct LanesOf;
template <>
struct LanesOf<double> {
  using Type [[gnu::vector_size(32)]] = double;
};
template <>
struct LanesOf<float> {
  using Type [[gnu::vector_size(16)]] = float;
};
template <class T>
using Lanes = typename LanesOf<T>::Type;

/// The type of a number, or of the numbers in its lanes.
template <class V>
struct ElementOf {
  using Type = V;
};
template <>
struct ElementOf<Lanes<double>> {
  using Type = double;
};
template <>
struct ElementOf<Lanes<float>> {
  using Type = float;
};
template <class V>
using Element = typename ElementOf<V>::Type;

template <class T>
[[gnu::always_inline]] inline Lanes<T> lanes_at(const T (&row)[4]) {
  Lanes<T> v;
  __builtin_memcpy(&v, row, sizeof v);
  return v;
}

/// A coefficient as it stands, or in every lane.
template <class V, class C>
[[gnu::always_inline]] inline V spread(const C& c) {
  if constexpr (std::is_same_v<V, C>) return c;
  else return V{} + c;
}

/// x to the powers of two.
template <class V>
struct Powers {
  V one, two, four, eight;

  [[gnu::always_inline]] explicit Powers(const V& x) : one(x), two(one * one), four(two * two), eight(four * four) {}
  template <int Exponent>
  [[gnu::always_inline]] const V& to() const {
    if constexpr (Exponent == 1) return one;
    else if constexpr (Exponent == 2) return two;
    else if constexpr (Exponent == 4) return four;
    else return eight;
  }
};

/// Estrin's scheme: halves that do not wait for each other. `coefficient(k)` belongs to x^k; zeros on top of a
/// polynomial do not change its value.
template <int Degree, int Lowest = 0, class V, class Coefficient>
[[gnu::always_inline]] inline V estrin(const Powers<V>& x, Coefficient coefficient) {
  static_assert(Degree < 16);
  if constexpr (Degree == 0) {
    return spread<V>(coefficient(Lowest));
  } else {
    constexpr int half = Degree >= 8 ? 8 : Degree >= 4 ? 4 : Degree >= 2 ? 2 : 1;
    return estrin<half - 1, Lowest>(x, coefficient) +
           x.template to<half>() * estrin<Degree - half, Lowest + half>(x, coefficient);
  }
}

/// A polynomial with its first three derivatives.
template <class V>
struct Taylor {
  V value, first, second, third;
};

template <int Degree, class V, class Coefficient>
[[gnu::always_inline]] inline Taylor<V> taylor(const V& s, Coefficient coefficient) {
  using T = Element<V>;
  const Powers<V> x(s);
  return {estrin<Degree>(x, coefficient),
          estrin<Degree - 1>(
              x, [&](int k) __attribute__((always_inline)) { return coefficient(k + 1) * T(k + 1); }),
          estrin<Degree - 2>(
              x, [&](int k) __attribute__((always_inline)) { return coefficient(k + 2) * T((k + 1) * (k + 2)); }),
          estrin<Degree - 3>(
              x, [&](int k)
                     __attribute__((always_inline)) { return coefficient(k + 3) * T((k + 1) * (k + 2) * (k + 3)); })};
}

template <int Degree, class V, class Coefficient>
[[gnu::always_inline]] inline V value(const V& s, Coefficient coefficient) {
  return estrin<Degree>(Powers<V>(s), coefficient);
}

/// The same number. The engines of WebAssembly make a constant of several lanes by three instructions wherever it is
/// used: one that the compiler does not know is kept from before the loop.
template <class T>
[[gnu::always_inline]] inline T kept(T number) {
#ifdef __wasm__
  asm("" : "+r"(number));
#endif
  return number;
}

template <class T, int N, class V>
[[gnu::always_inline]] inline V polynomial(const T (&c)[N], const V& x) {
  return value<N - 1>(
      x, [&c](int k) __attribute__((always_inline)) { return kept(c[k]); });
}

}  // namespace

}}}  // namespace orispline::batch
