// SPDX-License-Identifier: Apache-2.0
// Geodesic distance near 0 and near π, where the arc cosine would lose half the digits.
#include <orispline/math/so3.hpp>

#include <gtest/gtest.h>

#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::pi;

TEST(AngularDistance, IsTheAngleBetweenOrientationsAtMostHalfATurn) {
  const Eigen::Quaterniond from = exp<double>(Eigen::Vector3d(0.2, 0.9, -0.4));
  for (const double angle : testing_support::specimen_angles)
    for (const Eigen::Vector3d& axis : testing_support::specimen_axes()) {
      const double wanted = angle <= pi ? angle : 2 * pi - angle;
      EXPECT_NEAR(angular_distance(from, from * exp<double>(angle * axis)), wanted, 2 * tolerance::exact) << angle;
    }
}

TEST(AngularDistance, KeepsEveryDigitOfATinyAngle) {
  const Eigen::Quaterniond identity = Eigen::Quaterniond::Identity();
  for (const double angle : {1e-12, 1e-20, 1e-100})
    EXPECT_NEAR(angular_distance(identity, exp<double>(Eigen::Vector3d(0, angle, 0))), angle, tolerance::exact * angle);
}

TEST(AngularDistance, IsSymmetricAndBlindToTheSign) {
  const Eigen::Quaterniond a = exp<double>(Eigen::Vector3d(0.2, 0.9, -0.4));
  const Eigen::Quaterniond b = exp<double>(Eigen::Vector3d(-1.2, 0.1, 2.0));
  const Eigen::Quaterniond minus_b(-b.w(), -b.x(), -b.y(), -b.z());
  EXPECT_DOUBLE_EQ(angular_distance(a, b), angular_distance(b, a));
  EXPECT_DOUBLE_EQ(angular_distance(a, b), angular_distance(a, minus_b));
  EXPECT_EQ(angular_distance(Eigen::Quaterniond::Identity(), quaternion_wxyz(-1.0, 0.0, 0.0, 0.0)), 0.0);
}

}}  // namespace orispline
