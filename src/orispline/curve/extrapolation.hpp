// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/curve/path.hpp>
#include <orispline/fields/words.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a time outside a curve gets.
enum class Extrapolation {
  hold,     ///< the end orientation and position, at rest
  error,    ///< an error
  nan,      ///< NaN
  rate,     ///< motion at the angular and linear velocity of the end
  segment,  ///< what the formula of the end segment gives there
};

/// Their sentences go on after "samples outside the curve".
template <>
inline constexpr std::array words<Extrapolation>{
    word("hold", Extrapolation::hold, "hold the end orientation"), word("error", Extrapolation::error, "are an error"),
    word("nan", Extrapolation::nan, "are NaN"), word("rate", Extrapolation::rate, "keep the rate of the end"),
    word("segment", Extrapolation::segment, "follow the formula of the end segment")};

/// The motion at time t [s], inside the curve its own. Where t is outside and that is an error, NaN.
///
/// With `rate` the body turns on from the end Q with its velocity ω: Q exp((t − end) ω), without acceleration. With
/// `segment` far times may give numbers that are not finite.
[[nodiscard]] ORISPLINE_EXPORT Motion extrapolated(const AnyCurve& curve, double t, Extrapolation how) noexcept;

/// The position at time t [s], inside the path its own; outside it goes on in a straight line with `rate`.
[[nodiscard]] ORISPLINE_EXPORT LinearMotion extrapolated(const AnyPath& path, double t, Extrapolation how) noexcept;

}}  // namespace orispline
