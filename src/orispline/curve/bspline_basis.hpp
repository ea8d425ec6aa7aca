// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/cumulative_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Tails of the Cox–de Boor functions: β̃_k is the sum of those of control points k, k+1, … active on the span.
template <std::size_t Degree>
struct BSplineBasis {
  static constexpr std::size_t increments = Degree, stride = 1;
  static constexpr int degree = static_cast<int>(Degree);
  std::vector<double> knots;  ///< span i lies between knots[i + Degree - 1] and knots[i + Degree]

  template <Number T>
  [[nodiscard]] std::array<T, Degree> operator()(KnotSpan span, const T& t) const noexcept {
    const double* left = knots.data() + span.i + Degree - 1;
    std::array<T, Degree + 1> n{T(1.0)};
    for (std::size_t d = 1; d <= Degree; ++d) {
      T carried(0.0);
      for (std::size_t j = 0; j < d; ++j) {
        const double low = left[static_cast<std::ptrdiff_t>(j) + 1 - static_cast<std::ptrdiff_t>(d)];
        const double high = left[j + 1];
        const T share = n[j] / (high - low);
        n[j] = carried + (T(high) - t) * share;
        carried = (t - T(low)) * share;
      }
      n[d] = carried;
    }
    std::array<T, Degree> tails;
    T sum(0.0);
    for (std::size_t k = Degree; k >= 1; --k) tails[k - 1] = sum = sum + n[k];
    return tails;
  }
};

}}  // namespace orispline
