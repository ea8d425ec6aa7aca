// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_basis.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>

namespace orispline::families {

/// Cumulative B-spline of degree 2…5 on the key times: approximates its keys, C^(degree-1) in time on any knots.
///
/// It runs from the first key time to the last; on even times it starts and ends at those keys. Knots stand at the key
/// times for odd degrees and at the midpoints for even ones, and go on with the end spacing; control orientations
/// beyond the ends are the keys reflected at the end key.
struct BSpline {
  static constexpr std::array parameters{Parameter{"degree", 3.0, 2.0, 5.0, false}};
  static constexpr FamilyInfo info{.name = "bspline",
                                   .title = "Cumulative B-spline",
                                   .source = "Kim, Kim & Shin 1995; docs/families/bspline.md",
                                   .interpolates = false,
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .parameters = parameters};

  /// Tails of the Cox–de Boor functions: β̃_k is the sum of those of control points k, k+1, … active on the span.
  template <std::size_t Degree>
  struct Basis {
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

  [[nodiscard]] static Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<AnyPath> path(const Keyframes& keys, const FamilySettings& settings);
};

}  // namespace orispline::families
