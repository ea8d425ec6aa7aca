// SPDX-License-Identifier: Apache-2.0
// Piecewise slerp as a family.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(SlerpFamily, IsSlerpBetweenNeighbouringKeys) {
  const Keyframes keys = keyframes(random_walk(121, 6, Spacing::uneven));
  const AnyCurve curve = make_curve("slerp", keys).value();
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double h = keys.times()[i + 1] - keys.times()[i];
    const auto &a = keys.orientations()[i], &b = keys.orientations()[i + 1];
    for (const double u : {0.0, 0.3, 0.9}) {
      const Motion m = curve.motion(keys.times()[i] + u * h);
      EXPECT_TRUE(near(m.orientation, slerp<double>(a, b, u), tolerance::algebra));
      EXPECT_TRUE(near(m.angular_velocity, increment<double>(a, b) / h, tolerance::series));
      EXPECT_TRUE(near(m.angular_acceleration, Eigen::Vector3d::Zero(), tolerance::series));
    }
  }
}

TEST(SlerpFamily, GoesTheLongWayWithSignsAsGiven) {
  const Eigen::Quaterniond q = quaternion_wxyz(-std::cos(0.25), 0.0, 0.0, -std::sin(0.25));  // minus a turn of 0.5 rad
  const KeyframeData data{.times = {0.0, 1.0}, .orientations = {Eigen::Quaterniond::Identity(), q}};
  const AnyCurve curve = make_curve("slerp", keyframes(data)).value();
  EXPECT_TRUE(near(curve.motion(0.5).angular_velocity, Eigen::Vector3d(0, 0, -(2 * pi - 0.5)), tolerance::algebra));
  const AnyCurve shortest = make_curve("slerp", keyframes(data, Signs::shortest)).value();
  EXPECT_TRUE(near(shortest.motion(0.5).angular_velocity, Eigen::Vector3d(0, 0, 0.5), tolerance::algebra));
}

}}  // namespace orispline
