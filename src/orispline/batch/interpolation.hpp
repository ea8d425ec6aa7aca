// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <orispline/math/eigen.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// A part of a segment [s].
struct Subinterval {
  std::size_t segment;
  double start, end;
  [[nodiscard]] double middle() const noexcept { return start + 0.5 * (end - start); }
  /// The double nearest to the place x in [-1, 1].
  [[nodiscard]] double time(double x) const noexcept {
    return std::clamp(middle() + 0.5 * (end - start) * x, start, end);
  }
};

/// cos(π (k + shift) / n) for k = 0, 1, …
template <std::size_t Count>
[[nodiscard]] std::array<double, Count> cosines(double shift, double n) noexcept {
  std::array<double, Count> points;
  for (std::size_t k = 0; k < Count; ++k)
    points[k] = elementary::sine_cosine(std::numbers::pi * (static_cast<double>(k) + shift) / n).cosine;
  return points;
}

/// Chebyshev's nodes, each as far from those before it as can be, in the product of the distances: Newton's form then
/// keeps its digits (Leja's order).
template <std::size_t N>
[[nodiscard]] std::array<double, N> chebyshev_nodes() noexcept {
  auto points = cosines<N>(0.5, static_cast<double>(N));
  for (std::size_t k = 1; k < N; ++k) {
    const auto product = [&](double x) {
      double p = 1.0;
      for (std::size_t i = 0; i < k; ++i) p *= std::abs(x - points[i]);
      return p;
    };
    std::size_t best = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (product(points[i]) > product(points[best])) best = i;
    std::swap(points[k], points[best]);
  }
  return points;
}

/// Coefficients of a polynomial with vectors for values, powers of s = (t - middle) * per_step rising.
template <std::size_t N, int Components>
struct PowerSeries {
  using Vector = Eigen::Matrix<double, Components, 1>;
  std::array<Vector, N> powers;
  std::size_t count;  ///< of nodes that are different doubles: the others are left out
};

/// The polynomial through `value(t)` at the nodes, each rounded to a time that is a double: rounding of the values
/// stays as small as it is, where sums of Bernstein coefficients would magnify it up to 2ⁿ times.
template <int Components, std::size_t N, class Value>
[[nodiscard]] PowerSeries<N, Components> interpolated(const Subinterval& subinterval,
                                                      const std::array<double, N>& nodes, double per_step,
                                                      Value value) noexcept {
  PowerSeries<N, Components> series{.powers = {}, .count = 0};
  std::array<double, N> s;
  std::array<typename PowerSeries<N, Components>::Vector, N> differences;  // divided, of Newton's form
  std::size_t& count = series.count;
  for (const double node : nodes) {
    const double t = subinterval.time(node), place = (t - subinterval.middle()) * per_step;
    if (std::find(s.data(), s.data() + count, place) != s.data() + count) continue;
    s[count] = place;
    differences[count++] = value(t);
  }
  for (std::size_t order = 1; order < count; ++order)
    for (std::size_t k = count; k-- > order;)
      differences[k] = (differences[k] - differences[k - 1]) / (s[k] - s[k - order]);
  series.powers.fill(PowerSeries<N, Components>::Vector::Zero());
  for (std::size_t k = count; k-- > 0;) {  // times (s - s_k), plus the next difference
    for (std::size_t p = count; p-- > 1;) series.powers[p] = series.powers[p - 1] - s[k] * series.powers[p];
    series.powers[0] = differences[k] - s[k] * series.powers[0];
  }
  return series;
}

}}}  // namespace orispline::batch
