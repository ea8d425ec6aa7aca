// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <gtest/gtest.h>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/families/families.hpp>
#include <support/bspline_by_definition.hpp>

namespace orispline::testing_support {

template <class>
struct TypesOf;
template <class... F>
struct TypesOf<std::tuple<F...>> {
  using type = ::testing::Types<F...>;
};

/// The list of families for typed tests: only where a test needs other number types than the type-erased curve has.
using FamilyTypes = TypesOf<Families>::type;

/// Names typed tests by family instead of by number.
struct FamilyNames {
  template <class F>
  static std::string GetName(int) {
    return std::string(F::info.name);
  }
};

/// The tensions of one order of the general uniform family.
template <std::size_t K>
[[nodiscard]] families::UniformFamily::Basis<K> uniform_basis(const FamilySettings& settings) {
  families::UniformFamily::Basis<K> basis{
      [&]<std::size_t... M>(std::index_sequence<M...>)
          ->std::array<PerKey, K>{return {settings.per_key("tension" + std::to_string(M + 1))...};
}
(std::make_index_sequence<K>{})
};  // namespace orispline::testing_support
return basis;
}

/// A family's own curve through points of one kind, built with all its settings; those that choose the type at run time
/// at their defaults.
template <class F, CurvePoint P = Eigen::Quaterniond>
[[nodiscard]] auto typed_curve(const Keyframes& keys, const CurveOptions& options = {}) {
  const FamilySettings settings = settle(F::info, options, keys.size()).value();
  constexpr bool is_orientation = std::same_as<P, Eigen::Quaterniond>;
  if constexpr (std::same_as<F, families::UniformFamily>)
    return four_key_curve<P>(keys, settings, uniform_basis<2>(settings)).value();
  else if constexpr (std::same_as<F, families::BSpline>) return bspline_curve<3, P>(keys);
  else if constexpr (is_orientation && requires { F::chart(keys, settings); }) return F::chart(keys, settings).value();
  else return build<F, P>(keys, settings).value();
}

/// Its own path type.
template <class F>
[[nodiscard]] auto typed_path(const Keyframes& keys, const CurveOptions& options = {}) {
  return typed_curve<F, Eigen::Vector3d>(keys, options);
}

/// The k-th derivative in time of the orientation, not divided by k!, on one segment.
template <Curve C, std::size_t Orders = 5>
[[nodiscard]] std::array<Eigen::Vector4d, Orders> quaternion_derivatives(const C& curve, double t,
                                                                         std::size_t segment) {
  using J = Jet<double, static_cast<int>(Orders) - 1>;
  const Quaternion<J> q = curve.point(J::variable(t), segment);
  std::array<Eigen::Vector4d, Orders> derivatives;
  for (std::size_t k = 0; k < Orders; ++k)
    derivatives[k] = {q.x().derivative(k), q.y().derivative(k), q.z().derivative(k), q.w().derivative(k)};
  return derivatives;
}

}  // namespace orispline::testing_support
