// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <gtest/gtest.h>

#include <orispline/families/families.hpp>

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

/// A family's own curve type, built with all its settings.
template <class F>
[[nodiscard]] auto typed_curve(const Keyframes& keys, const CurveOptions& options = {}) {
  const FamilySettings settings = settle(F::info, options, keys.size()).value();
  if constexpr (requires { F::basis(settings); }) return four_key_curve(keys, settings, F::basis(settings)).value();
  else return F::curve(keys, settings).value();
}

/// The k-th derivative in time of the orientation, not divided by k!, on one segment.
template <Curve C, std::size_t Orders = 5>
[[nodiscard]] std::array<Eigen::Vector4d, Orders> quaternion_derivatives(const C& curve, double t,
                                                                         std::size_t segment) {
  using J = Jet<double, static_cast<int>(Orders) - 1>;
  const Quaternion<J> q = curve.orientation(J::variable(t), segment);
  std::array<Eigen::Vector4d, Orders> derivatives;
  for (std::size_t k = 0; k < Orders; ++k)
    derivatives[k] = {q.x().derivative(k), q.y().derivative(k), q.z().derivative(k), q.w().derivative(k)};
  return derivatives;
}

}  // namespace orispline::testing_support
