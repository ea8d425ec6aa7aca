// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline::optimise {

/// The largest of a quantity on one segment: what was found at a time, and what it is nowhere above.
struct CertifiedPeak {
  double found = 0.0, bound = 0.0;
  double time = 0.0;  ///< of `found` [s]
};

/// The peaks of one segment.
struct SegmentPeaks {
  CertifiedPeak rate{};          ///< |ω| [rad/s]
  CertifiedPeak acceleration{};  ///< |α| [rad/s²]
  CertifiedPeak torque{};        ///< |I α + ω × I ω| [N m]; 0 without an inertia
};

/// Bounds below these are near enough, whatever the largest value; infinite for what nobody asks for.
struct PeakFloors {
  double rate, acceleration, torque;  ///< [rad/s], [rad/s²], [N m]
};

/// The peaks of every segment on its closed interval, by bounds and not by samples; nothing where the curve does not
/// state its segments as polynomials.
///
/// A bound G of the jerk on the segment turns the motion at the middle of an interval of half length r into bounds on
/// all of it, |ω| ≤ |ω_m| + |α_m| r + G r²/2 and |α| ≤ |α_m| + G r; intervals are halved until no bound is more than
/// 1e-4 of the largest value above it, or all are below the floors, or 14 times. For q = ∏ exp(X_k) of pure quaternions
/// X_k, all exponentials are of norm 1, so that with A_n = Σ_k |X_k^(n)|, bounded by the Bernstein coefficients of the
/// derivatives, |q'| ≤ A_1, |q''| ≤ A_2 + A_1², |q'''| ≤ A_3 + 3 A_1 A_2 + A_1³, and G = 2 (A_3 + 6 A_1 A_2 + 4 A_1³)
/// from ω = 2 q̄ q'. Source: our own derivation, docs/retime.md.
[[nodiscard]] std::optional<std::vector<SegmentPeaks>> certified_peaks(const AnyCurve& curve,
                                                                       const std::optional<Eigen::Matrix3d>& inertia,
                                                                       const PeakFloors& floors);

}  // namespace orispline::optimise
