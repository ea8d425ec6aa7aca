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

/// The largest of every segment at 17 even places of its closed interval.
[[nodiscard]] std::vector<QuantitySizes> sampled_peaks(const PoseCurve& curve, const MotionQuantities& quantities);

/// What the snap, the derivative of the jerk, is nowhere above on a segment [rad/s⁴]; absent for one that is not of
/// polynomials. `duration` [s].
///
/// For q = ∏ exp(X_k) of pure quaternions X_k, all exponentials are of norm 1, so that with A_n = Σ_k |X_k^(n)|,
/// bounded by the Bernstein coefficients of the derivatives, |q^(n)| ≤ Q_n with Q_1 = A_1, Q_2 = A_2 + A_1², Q_3 = A_3
/// + 3 A_1 A_2 + A_1³, Q_4 = A_4 + 4 A_1 A_3 + 3 A_2² + 6 A_1² A_2 + A_1⁴, and from ω = 2 q̄ q' the snap is at most 2
/// (Q_4 + 4 Q_1 Q_3 + 3 Q_2²). A bound that does not depend on where in its turns the body is counts where it is lower.
/// Source: our own derivation, docs/retime.md.
[[nodiscard]] std::optional<double> snap_bound(const SegmentForm& form, double duration);

/// The peaks of every segment on its closed interval, by bounds and not by samples; nothing where the curve does not
/// state its segments as polynomials.
///
/// `floors`: bounds below these are near enough, whatever the largest value; infinite for what nobody asks for.
/// The bound S of the snap turns the motion at the middle of an interval of half length r into bounds on all of it,
/// with the jerk j: |ω| ≤ max |ω_m ± α_m r| + |j_m| r²/2 + S r³/6, |α| ≤ max |α_m ± j_m r| + S r²/2 and |j| ≤ |j_m| + S
/// r, for a straight line is longest at an end; likewise components and the torque. Bounds of SegmentHull count where
/// they are nearer; those of positions are of PathHull alone. The interval of the worst bound is halved until no bound
/// is more than 1e-4 of the largest value above it, or all are below the floors, or there are very many. The rounding
/// of the keys, also when they are written and read again, is in the bounds. Source: our own derivation,
/// docs/retime.md.
[[nodiscard]] std::optional<std::vector<SegmentPeaks>> certified_peaks(const PoseCurve& curve,
                                                                       const MotionQuantities& quantities,
                                                                       const QuantitySizes& floors);

}}  // namespace orispline
