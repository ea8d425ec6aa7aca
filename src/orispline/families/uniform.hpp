// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/two_point_blending.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The general uniform four-key family of order k = 1…5: C^k on uniform knots, degree 2k+1, k tensions per key.
///
/// In R^d the m-th derivative at key i is t_m (P_{i+1} - P_{i-1}) for odd m and t_m (P_{i+1} - 2P_i + P_{i-1}) for even
/// m. Order 2 with equal tensions is Tan's quintic; order 3 with (6β, 5/2, 30 - 360β) the 6th-degree spline.
struct UniformFamily {
  static constexpr std::array parameters{
      Parameter{"order", 2.0, 1.0, 5.0, false},      tunable(resting_at_zero({"tension1", 0.5, -100.0, 100.0})),
      tunable({"tension2", 1.0, -100.0, 100.0}),     tunable({"tension3", 0.0, -1000.0, 1000.0}),
      Parameter{"tension4", 0.0, -10000.0, 10000.0}, Parameter{"tension5", 0.0, -100000.0, 100000.0}};
  static constexpr FamilyInfo info{.name = "uniform",
                                   .alias = "family",
                                   .title = "General local spline for even keys, of order 1 to 5",
                                   .source = "orispline, docs/families/uniform.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_repeat,
                                   .closes = true};

  template <std::size_t K>
  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 2 * static_cast<int>(K) + 1;
    std::array<PerKey, K> tensions;

    [[nodiscard]] FourKeyBlending<K> coefficients(KnotSpan span) const noexcept {
      return two_point_blending<K>(at_key(span.i), at_key(span.i + 1));
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }

    /// φ_m = ±t_m (plus for odd m), ψ_m = t_m.
    [[nodiscard]] KnotDerivatives<K> at_key(std::size_t key) const noexcept {
      KnotDerivatives<K> d{};
      for (std::size_t m = 1; m <= K; ++m) {
        d.psi[m - 1] = tensions[m - 1][key];
        d.phi[m - 1] = m % 2 == 1 ? d.psi[m - 1] : -d.psi[m - 1];
      }
      return d;
    }
  };

  /// What `build` makes of the basis of the order that the settings ask for.
  template <class Result, class Build>
  [[nodiscard]] static Expected<Result> with_basis(const FamilySettings& settings, Build build) {
    const auto order = settings.whole("order");
    if (!order) return tl::unexpected(order.error());
    const auto as_result = [](auto built) { return Result(std::move(built)); };
    switch (*order) {
      case 1:
        return build(basis_of_order<1>(settings)).map(as_result);
      case 2:
        return build(basis_of_order<2>(settings)).map(as_result);
      case 3:
        return build(basis_of_order<3>(settings)).map(as_result);
      case 4:
        return build(basis_of_order<4>(settings)).map(as_result);
      default:
        return build(basis_of_order<5>(settings)).map(as_result);
    }
  }

  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<AnyCurveThrough<P>> curve(const Keyframes& keys, const FamilySettings& settings);

 private:
  template <std::size_t K>
  [[nodiscard]] static Basis<K> basis_of_order(const FamilySettings& settings) {
    return [&]<std::size_t... M>(std::index_sequence<M...>) {
      return Basis<K>{{settings.per_key("tension" + std::to_string(M + 1))...}};
    }
    (std::make_index_sequence<K>{});
  }
};

}}}  // namespace orispline::families
