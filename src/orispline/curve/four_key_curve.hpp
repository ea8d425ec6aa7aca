// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/control_points.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/loop.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

[[nodiscard]] inline Knots four_key_knots(const Keyframes& keys, const FamilySettings& settings) {
  return settings.closure ? closed_knots(keys, *settings.closure) : key_knots(keys);
}

/// A local interpolating curve whose segment i blends keys i-1 … i+2, open or closed: the shape of the papers' splines
/// and of ours in time.
template <CurvePoint P = Eigen::Quaterniond, CumulativeBasis B>
[[nodiscard]] Expected<CumulativeCurve<B, P>> four_key_curve(const Keyframes& keys, const FamilySettings& settings,
                                                             B basis) {
  Knots knots = four_key_knots(keys, settings);
  auto polygon = settings.closure ? Expected<ControlPolygon<P>>(closed_polygon<P>(keys, *settings.closure))
                                  : ghosted_polygon<P>(keys, settings, start_weights(basis, knots.span(0)),
                                                       end_weights(basis, knots.span(knots.segments() - 1)));
  return std::move(polygon).map(
      [&](ControlPolygon<P>&& p) { return CumulativeCurve<B, P>(std::move(knots), std::move(basis), std::move(p)); });
}

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
