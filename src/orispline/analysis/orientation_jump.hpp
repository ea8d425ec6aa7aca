// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <orispline/analysis/continuity.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a curve moves at a time.
struct TimedMotion {
  double time;
  Motion motion;
};

/// On one segment: at its ends and at three places between them.
[[nodiscard]] std::array<TimedMotion, 5> probes_of(const AnyCurve& curve, std::size_t segment) noexcept;

/// The first jump of a segment, looked for between neighbouring probes where the orientations lie farther apart than
/// the rates between them allow. One that is smaller than 1e-6 rad is rounding.
[[nodiscard]] OrientationJump jump_between(std::span<const TimedMotion> probes, const AnyCurve& curve,
                                           std::size_t segment) noexcept;

}}  // namespace orispline
