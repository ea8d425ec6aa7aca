// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// Bernstein coefficients of the cumulative blending functions of every segment of a curve: segment after segment, row
/// after row. Immutable; copies share them.
struct SegmentCoefficients {
  std::size_t degree;
  std::shared_ptr<const std::vector<double>> values;
};

/// M cumulative blending functions that are stored for each segment.
template <std::size_t M>
struct StoredBasis {
  static constexpr std::size_t increments = M, stride = 1;
  static constexpr int degree = 0;  ///< known of each curve only
  SegmentCoefficients coefficients;

  template <Number T>
  [[nodiscard]] std::array<T, M> operator()(KnotSpan span, const T& t) const noexcept {
    const std::size_t n = coefficients.degree;
    const auto basis = bernstein_basis_of<BlendingFamily::highest_degree>(n, span.normalised(t));
    std::array<T, M> sums{};
    for (std::size_t k = 0; k < M; ++k)
      for (std::size_t i = 0; i <= n; ++i) sums[k] += basis[i] * Plain<T>(row(span.i, k)[i]);
    return sums;
  }

  [[nodiscard]] std::size_t stored_degree() const noexcept { return coefficients.degree; }
  /// The functions of a segment, of degree `form_degree` at most.
  [[nodiscard]] std::array<BernsteinForm, 3> forms(std::size_t segment) const noexcept requires(M <= 3) {
    std::array<BernsteinForm, 3> forms{};
    for (std::size_t k = 0; k < M; ++k)
      std::copy_n(row(segment, k), coefficients.degree + 1, forms[k].coefficients.begin());
    return forms;
  }

 private:
  [[nodiscard]] const double* row(std::size_t segment, std::size_t k) const noexcept {
    return coefficients.values->data() + (segment * M + k) * (coefficients.degree + 1);
  }
};

}}}  // namespace orispline::blending
