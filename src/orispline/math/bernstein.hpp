// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The Bernstein polynomials of degree n at u: B_i(u) = C(n,i) uⁱ (1-u)^(n-i), i = 0…n. The degree, at most Most, is a
/// number, or a std::integral_constant where the compiler is to know it; what lies beyond is not set.
template <std::size_t Most, Number T>
[[nodiscard]] std::array<T, Most + 1> bernstein_basis_of(auto n, const T& u) noexcept {
  const T v = T(1.0) - u;
  std::array<T, Most + 1> basis, powers_of_v;
  powers_of_v[0] = T(1.0);
  for (std::size_t i = 1; i <= n; ++i) powers_of_v[i] = powers_of_v[i - 1] * v;
  T power_of_u(1.0);
  double binomial = 1.0;
  for (std::size_t i = 0; i <= n; ++i) {
    basis[i] = power_of_u * powers_of_v[n - i] * Plain<T>(binomial);
    power_of_u = power_of_u * u;
    binomial = binomial * static_cast<double>(n - i) / static_cast<double>(i + 1);
  }
  return basis;
}

/// Those of degree N.
template <std::size_t N, Number T>
[[nodiscard]] std::array<T, N + 1> bernstein_basis(const T& u) noexcept {
  return bernstein_basis_of<N>(std::integral_constant<std::size_t, N>{}, u);
}

/// The cumulative Bernstein polynomials of degree N at u: B_k(u) + … + B_N(u), k = 1…N.
template <std::size_t N, Number T>
[[nodiscard]] std::array<T, N> cumulative_bernstein_basis(const T& u) noexcept {
  const auto basis = bernstein_basis<N>(u);
  std::array<T, N> tails;
  T sum(0.0);
  for (std::size_t k = N; k >= 1; --k) tails[k - 1] = sum += basis[k];
  return tails;
}

/// The Bernstein coefficients of K polynomials of degree M-1, one polynomial a row.
template <std::size_t K, std::size_t M>
using BernsteinRows = std::array<std::array<double, M>, K>;

/// Polynomials in Bernstein form over one shared basis: row k of `coefficients` gives the k-th value.
template <std::size_t K, std::size_t M, Number T>
[[nodiscard]] std::array<T, K> bernstein_sums(const BernsteinRows<K, M>& coefficients, const T& u) noexcept {
  const auto basis = bernstein_basis<M - 1>(u);
  std::array<T, K> sums{};
  for (std::size_t k = 0; k < K; ++k)
    for (std::size_t i = 0; i < M; ++i) sums[k] += basis[i] * Plain<T>(coefficients[k][i]);
  return sums;
}

}}  // namespace orispline
