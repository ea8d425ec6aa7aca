// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/path.hpp>
#include <orispline/retime/motion_limits.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What is measured of a motion. Refers to both.
struct MotionQuantities {
  std::span<const LimitedQuantity> all;
  const std::optional<Eigen::Matrix3d>& inertia;  ///< for torques
};

/// The largest of every segment at 17 even places of its closed interval: while times are sought, for which bounds of
/// thousands of curves would take too long. What is found is certified then.
[[nodiscard]] std::vector<QuantitySizes> sampled_peaks(const PoseCurve& curve, const MotionQuantities& quantities);

/// The peaks of every segment on its closed interval, by bounds and not by samples; nothing where the curve does not
/// state its segments as polynomials.
///
/// `floors`: bounds below these are near enough, whatever the largest value; infinite for what nobody asks for. The
/// bound S of the snap turns the motion at the middle of an interval of half length r into bounds on all of it, with
/// the jerk j: |ω| ≤ max |ω_m ± α_m r| + |j_m| r²/2 + S r³/6, |α| ≤ max |α_m ± j_m r| + S r²/2 and |j| ≤ |j_m| + S r,
/// for a straight line is longest at an end; so it is with components and the torque. Bounds of SegmentHull count where
/// they are nearer; those of positions are of PathHull alone. The interval of the worst bound is halved until no bound
/// is more than 1e-4 of the largest value above it, or all are below the floors, or there are very many. The rounding
/// of the keys, also when they are written and read again, is in the bounds. Source: our own derivation,
/// docs/retime.md.
[[nodiscard]] std::optional<std::vector<SegmentPeaks>> certified_peaks(const PoseCurve& curve,
                                                                       const MotionQuantities& quantities,
                                                                       const QuantitySizes& floors);

}}  // namespace orispline
