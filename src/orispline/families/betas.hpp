// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/loop.hpp>

// What the Beta curves have in common: their parameters, and the published curve of auxiliary points. Those of a loop
// are its points with one before and two behind them, so that each arc at the seam has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// One of each per key.
template <Number T>
struct BetasOver {
  std::vector<T> beta1, beta2;
};
using Betas = BetasOver<double>;

[[nodiscard]] inline Betas betas_of(const FamilySettings& settings, std::size_t keys) {
  return {settings.per_key("beta1").all(keys), settings.per_key("beta2").all(keys)};
}

/// Those of the auxiliary points of a curve that has one per key.
[[nodiscard]] inline Betas auxiliary_betas(const FamilySettings& settings, std::size_t keys) {
  if (!settings.closure) return betas_of(settings, keys);
  return {values_around(settings.per_key("beta1"), keys), values_around(settings.per_key("beta2"), keys)};
}

/// How the arcs between these are divided. Errors: those of beta_shape(), with the key.
[[nodiscard]] inline Expected<BetaShape> auxiliary_shape(const FamilySettings& settings, std::size_t keys) {
  const Betas own = betas_of(settings, keys);
  return beta_shape(settings.method, own.beta1, own.beta2).map([&](const BetaShape& shape) {
    if (!settings.closure) return shape;
    const Betas around = auxiliary_betas(settings, keys);
    return beta_shape_over(around.beta1, around.beta2);
  });
}

/// The published curve, whose auxiliary points are the keys.
template <CurvePoint P>
[[nodiscard]] ControlPolygon<P> published_polygon(const Keyframes& keys, const FamilySettings& settings,
                                                  const BetaShape& shape) {
  const auto points = keys.points<P>();
  if (!settings.closure) return beta_polygon(points, shape);
  return beta_polygon(std::span<const P>(points_around(points, *settings.closure)), shape);
}

/// Its joints in time: all keys of a loop, else all but the first and the last.
[[nodiscard]] inline Knots published_knots(const Keyframes& keys, const FamilySettings& settings) {
  return settings.closure ? closed_knots(keys, *settings.closure) : inner_key_knots(keys);
}

}}}  // namespace orispline::families
