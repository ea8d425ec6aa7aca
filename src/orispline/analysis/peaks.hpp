// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The largest length of a rate, and the first time when it is reached [s].
struct Peak {
  double value = 0.0, time = 0.0;
};

struct Peaks {
  Peak angular_velocity{};      ///< [rad/s]
  Peak angular_acceleration{};  ///< [rad/s²]
  Peak torque{};                ///< ‖J α + ω × J ω‖ [N m]; that of α for unit inertia
};

/// The peaks over the whole curve, the one-sided rates at the keys among them.
///
/// Each segment is searched in 16 steps; a maximum between two of them is found by bisection of the exact derivative
/// (ω·α, α·jerk, torque times its rate), to the rounding of time.
[[nodiscard]] ORISPLINE_EXPORT Peaks peaks(const AnyCurve& curve,
                                           const Eigen::Matrix3d& inertia = Eigen::Matrix3d::Identity());

}}  // namespace orispline
