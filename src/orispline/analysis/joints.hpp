// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include <orispline/analysis/continuity.hpp>
#include <orispline/curve/stretched_curve.hpp>

// The places where segments of a curve meet, with the rates on both sides, and what lies between them.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Where two segments meet.
struct Joint {
  std::size_t key;
  double spacing;  // the smaller one beside it [s]
  Motion left, right;
};

/// Calls `look` for every interior key and, of a loop, for its seam (key 0).
template <class Look>
void for_each_joint(const AnyCurve& curve, Seam seam, Look&& look) {
  const auto t = curve.knots().times();
  for (std::size_t i = 1; i + 1 < t.size(); ++i)
    look(Joint{i, std::min(t[i] - t[i - 1], t[i + 1] - t[i]), curve.motion(t[i], Side::left),
               curve.motion(t[i], Side::right)});
  if (seam == Seam::open || t.size() < 2) return;
  const std::size_t last = t.size() - 1;
  look(Joint{0, std::min(t[1] - t[0], t[last] - t[last - 1]), curve.motion(t[last]), curve.motion(t[0])});
}

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

/// Calls `look` with motions that show how fast the curve is: at the ends and at three points of each segment. Gives
/// the largest jump of the orientation between its keys.
template <class Look>
[[nodiscard]] OrientationJump look_between_keys(const AnyCurve& curve, Look&& look) {
  OrientationJump largest;
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    if (is_gap(curve, i)) continue;
    const auto probes = probes_of(curve, i);
    for (const TimedMotion& probe : probes) look(probe.motion);
    const OrientationJump found = jump_between(probes, curve, i);
    if (found.angle > largest.angle) largest = found;
  }
  return largest;
}

}}  // namespace orispline
