// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// How far times are rounded.
enum class TimeRounding { to_float, to_double };

/// How far from its exact value a time may be [s].
[[nodiscard]] double rounding_at(double time, TimeRounding rounding) noexcept;

/// From the least to the most that a step may be [s].
struct StepRange {
  double least, most;

  [[nodiscard]] bool has(double step) const noexcept { return least <= step && step <= most; }
  [[nodiscard]] double middle() const noexcept { return least + (most - least) / 2; }
  /// The decimal of the fewest digits in it, the nearest to its middle of those.
  [[nodiscard]] Decimal shortest() const;
};

/// More frames than this are not written.
inline constexpr double most_frames = 1e8;

/// The steps of the coarsest even grid from the first time on that has all times within their rounding; nothing where
/// there is none. `times`: two at least, rising.
[[nodiscard]] std::optional<StepRange> even_steps_of(std::span<const double> times, TimeRounding rounding);

}}}  // namespace orispline::scenes::bvh
