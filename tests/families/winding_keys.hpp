// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline::testing_support {

/// Keys about one axis, the fourth of which points aside by so much [rad]. Short steps stand beside long ones, so that
/// a curve of three keys goes on for several turns. The positions are the angles along the axis.
[[nodiscard]] inline Keyframes winding_keys_about_one_axis(double aside = 0.0) {
  KeyframeData data{.times = {0.0, 60.0, 62.0, 80.0, 81.0, 81.5, 120.0}};
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  for (const double angle : {0.0, 0.0, 1.2, 0.3, 2.4, 0.4, 1.0}) {
    data.positions.push_back(angle * axis);
    data.orientations.push_back(exp<double>(angle * axis));
  }
  data.orientations[3] = data.orientations[3] * exp<double>(aside * Eigen::Vector3d(0.8, 0.64, 0.0));
  return keyframes(data);
}

/// The orientation is what its positions, as rotation vectors, say.
inline void expect_the_turn_of_its_path(const Method& method, const Keyframes& keys) {
  const PoseCurve pose = make_pose_curve(method, keys).value();
  double farthest = 0.0;
  for (const double t : sample_times(keys.times(), 23)) {
    const LinearMotion path = pose.position->linear_motion(t);
    const Motion motion = pose.orientation.motion(t);
    farthest = std::max(farthest, path.position.norm());
    EXPECT_TRUE(near(motion.orientation, exp<double>(path.position), tolerance::series)) << method.name << " " << t;
    EXPECT_TRUE(near(motion.angular_velocity, path.velocity, tolerance::rates)) << method.name << " " << t;
    EXPECT_TRUE(near(motion.angular_acceleration, path.acceleration, tolerance::rates)) << method.name << " " << t;
  }
  EXPECT_GT(farthest, 4.0 * pi) << "nothing winds";
}

}  // namespace orispline::testing_support
