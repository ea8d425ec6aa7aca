// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/control_points.hpp>
#include <orispline/curve/loop.hpp>

namespace orispline {

[[nodiscard]] inline Knots four_key_knots(const Keyframes& keys, const FamilySettings& settings) {
  return settings.closure ? closed_knots(keys, *settings.closure) : Knots({keys.times().begin(), keys.times().end()});
}

/// A local interpolating curve whose segment i blends keys i-1 … i+2, open or closed: the shape of the papers' splines
/// and of ours in time.
template <CumulativeBasis B>
[[nodiscard]] Expected<CumulativeCurve<B>> four_key_curve(const Keyframes& keys, const FamilySettings& settings,
                                                          B basis) {
  Knots knots = four_key_knots(keys, settings);
  auto polygon = settings.closure ? Expected<ControlPolygon>(closed_polygon(keys, *settings.closure))
                                  : ghosted_polygon(keys, settings, start_weights(basis, knots.span(0)),
                                                    end_weights(basis, knots.span(knots.segments() - 1)));
  return std::move(polygon).map(
      [&](ControlPolygon&& p) { return CumulativeCurve<B>(std::move(knots), std::move(basis), std::move(p)); });
}

/// Its Euclidean analogue through the keys' positions.
template <CumulativeBasis B>
[[nodiscard]] Expected<CumulativePath<B>> four_key_path(const Keyframes& keys, const FamilySettings& settings,
                                                        B basis) {
  Knots knots = four_key_knots(keys, settings);
  auto polygon = settings.closure ? Expected<PathPolygon>(closed_path(keys))
                                  : ghosted_path(keys, settings, start_weights(basis, knots.span(0)),
                                                 end_weights(basis, knots.span(knots.segments() - 1)));
  return std::move(polygon).map(
      [&](PathPolygon&& p) { return CumulativePath<B>(std::move(knots), std::move(basis), std::move(p)); });
}

}  // namespace orispline
