// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/analysis/continuity.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The direction of a path beside a key: that of ω, or at a rest its limit.
struct DirectionBeside {
  int order;  ///< of the rate that it is taken from: 1 where the body moves
  Eigen::Vector3d direction;
  double rounding;
};

/// The limit of ω/‖ω‖ on one side of a key: near a rest ω is ατ, or jτ²/2 where α vanishes too. Absent where all three
/// do. `spacing`: the smaller one beside the key [s]; `in_time`: of the curve.
[[nodiscard]] std::optional<DirectionBeside> direction_beside(const Motion& motion, Side side, double spacing,
                                                              const Continuity& in_time);

}}  // namespace orispline
