// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/key_knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Piecewise slerp: the geodesic between neighbouring keys at constant rate. C0.
struct Slerp {
  static constexpr FamilyInfo info{.name = "slerp",
                                   .title = "Spherical linear interpolation",
                                   .source = "Eberly, (16); Shoemake 1985",
                                   .continuity_uniform = 0,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 2};

  struct Basis {
    static constexpr std::size_t increments = 1, stride = 1;
    static constexpr int degree = 1;
    template <Number T>
    [[nodiscard]] std::array<T, 1> operator()(KnotSpan span, const T& t) const noexcept {
      return {span.normalised(t)};
    }
  };

  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<CumulativeCurve<Basis, P>> curve(const Keyframes& keys, const FamilySettings&) {
    return CumulativeCurve<Basis, P>(key_knots(keys), {}, keys.points<P>());
  }
};

}}}  // namespace orispline::families
