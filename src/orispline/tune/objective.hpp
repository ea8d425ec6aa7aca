// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What tuning makes as small as it can.
enum class Objective {
  linearised,    ///< ∫|Σ β̃_k'' φ_k|² dt [rad²/s³]: ∫|α|² less what the factors turn each other
  acceleration,  ///< ∫|α|² dt [rad²/s³]
  torque,        ///< ∫|J α + ω × J ω|² dt, body frame [(kg m²)² rad²/s³ = N² m² s]
  jerk,          ///< ∫|dα/dt|² dt, body frame [rad²/s⁵]
  curvature,     ///< ∫|κ|² ds = ∫|α⊥|²/|ω|³ dt [1/rad], of the path whatever its speed: PathShape
  fit,           ///< mean square of the angle to a reference [rad²]
};

/// An orientation that the curve should pass at u in [0, 1] of a segment.
struct ReferenceSample {
  double u;
  Eigen::Quaterniond orientation;
};

/// An objective with all that it needs.
struct Goal {
  Objective objective = Objective::linearised;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();          ///< [kg m²], body frame; of the torque
  std::vector<std::vector<ReferenceSample>> reference_samples{};  ///< by segment; of the fit
  std::size_t sample_count = 0;
};

/// So much of an objective is rounding of the keys, and no gain.
///
/// The rates of a segment are as uncertain as those of the shortest step beside it.
[[nodiscard]] ORISPLINE_EXPORT double rounding_of(const Goal& goal, const Keyframes& keys) noexcept;

}}  // namespace orispline
