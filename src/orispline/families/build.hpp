// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/four_key_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A family that states a four-key basis: the common rule builds its curves.
template <class F>
concept FourKeyFamily = requires(const FamilySettings& settings) {
  F::basis(settings);
};

/// A family's curve through points of one kind, in its own type. What it states is a four-key basis, one construction
/// `curve<P>` for orientations and positions, or a `curve` and a `path` where these truly differ.
template <class F, CurvePoint P>
[[nodiscard]] auto build(const Keyframes& keys, const FamilySettings& settings) {
  if constexpr (FourKeyFamily<F>) return four_key_curve<P>(keys, settings, F::basis(settings));
  else if constexpr (requires { F::template curve<P>(keys, settings); }) return F::template curve<P>(keys, settings);
  else if constexpr (std::same_as<P, Eigen::Quaterniond>) return F::curve(keys, settings);
  else return F::path(keys, settings);
}

}}  // namespace orispline
