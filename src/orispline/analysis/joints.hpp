// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/segment_motions.hpp>

// The places where segments of a curve meet, with the rates on both sides, and what lies between them.

namespace orispline { inline namespace ORISPLINE_ABI {

/// A smaller jump of the orientation is rounding [rad].
inline constexpr double smallest_jump = 1e-6;

/// Where two segments meet.
struct SegmentJoint {
  std::size_t key;
  double time;     // of the key [s]
  double spacing;  // the smaller one beside it [s]
  Motion left, right;
};

/// Calls `look` for every interior key but those where the motion jumps and, of a loop, for its seam (key 0).
template <class Look>
void for_each_joint(const AnyCurve& curve, Seam seam, Look&& look) {
  const auto t = curve.knots().times();
  for (std::size_t i = 1; i + 1 < t.size(); ++i)
    if (const double spacing = std::min(t[i] - t[i - 1], t[i + 1] - t[i]); spacing > 0.0)
      look(SegmentJoint{i, t[i], spacing, curve.motion_on(i - 1, t[i]), curve.motion_on(i, t[i])});
  if (seam == Seam::open || t.size() < 2) return;
  const std::size_t last = t.size() - 1;
  look(SegmentJoint{0, t[0], std::min(t[1] - t[0], t[last] - t[last - 1]), curve.motion(t[last]), curve.motion(t[0])});
}

/// How a curve moves at a time.
struct TimedMotion {
  double time;
  Motion motion;
};

/// One segment at its ends and at three places between them.
class Probes {
 public:
  Probes(const AnyCurve& curve, std::size_t segment) noexcept;
  Probes(const Probes&) = delete;

  /// None in a gap.
  [[nodiscard]] std::span<const TimedMotion> all() const noexcept { return {probes_.data(), count_}; }
  /// The first jump, looked for between neighbours where the orientations lie farther apart than the rates between them
  /// allow. One that is smaller than 1e-6 rad is rounding.
  [[nodiscard]] OrientationJump jump() noexcept;

 private:
  [[nodiscard]] OrientationJump jump_between(const TimedMotion& a, const TimedMotion& b, int depth = 0) noexcept;

  SegmentMotions motions_;
  std::size_t segment_;
  std::array<TimedMotion, 5> probes_;
  std::size_t count_ = 0;
};

/// Calls `look` with motions that show how fast the curve is, at the ends and at three points of each segment, and
/// `jumped` with the jump of the orientation in a segment, where there is one.
template <class Look, class Jumped>
void look_between_keys(const AnyCurve& curve, Look&& look, Jumped&& jumped) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    Probes probes(curve, i);
    for (const TimedMotion& probe : probes.all()) look(probe.motion);
    if (const OrientationJump found = probes.jump(); found.angle > 0.0) jumped(found);
  }
}

}}  // namespace orispline
