// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/math/eigen.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// What the body that follows the motion can do, everywhere and always; absent: not limited.
struct MotionLimits {
  std::optional<double> rate{};              ///< |ω| [rad/s]
  std::optional<double> acceleration{};      ///< |α| [rad/s²]
  std::optional<double> torque{};            ///< |I α + ω × I ω| [N m]
  std::optional<Eigen::Matrix3d> inertia{};  ///< I [kg m²], body frame; for the torque
};

}  // namespace orispline::inline ORISPLINE_ABI
