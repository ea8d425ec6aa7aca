// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>

#include <orispline/curve/knots.hpp>
#include <orispline/math/jet.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Cumulative blending functions: what a family of the form q(t) = q₀ ∏ exp(β̃_k(t) φ_k) states about itself.
///
/// On the knot span i, `b(span, t)` gives β̃_1…β̃_m at time t [s] over any Number; knot spacing enters by the chain
/// rule, so that a Jet in t yields time derivatives. `increments` is m, `stride` the number of control points that the
/// next span moves on, `degree` the largest polynomial degree in t, 0 for other functions.
template <class B>
concept CumulativeBasis = requires(const B& b, KnotSpan span, double t, Jet<double, 3> jet) {
  { B::increments } -> std::convertible_to<std::size_t>;
  { B::stride } -> std::convertible_to<std::size_t>;
  { B::degree } -> std::convertible_to<int>;
  { b(span, t) } -> std::same_as<std::array<double, B::increments>>;
  { b(span, jet) } -> std::same_as<std::array<Jet<double, 3>, B::increments>>;
};

}}  // namespace orispline
