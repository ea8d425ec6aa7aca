// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// All orientations within an angle of one.
struct Ball {
  Eigen::Quaterniond centre;
  double radius;  ///< [rad]
};

/// The ball round a centre that holds these orientations, one at least.
[[nodiscard]] Ball ball_round(const Eigen::Quaterniond& centre, std::span<const Eigen::Quaterniond> orientations);

/// A ball that holds these orientations, one at least: the smallest if that is smaller than π/2, to about 1e-8 rad.
///
/// In such a ball all unit quaternions of the right signs lie in a cap of the sphere, whose centre is the direction of
/// the point of their convex hull that is nearest to 0. Source of the search for it: Wolfe 1976.
[[nodiscard]] Ball smallest_ball(std::span<const Eigen::Quaterniond> orientations);

}}}  // namespace orispline::mean_of
