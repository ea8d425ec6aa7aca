// SPDX-License-Identifier: Apache-2.0
// Jacobians of SO(3) against the derivative of exp itself.
#include <orispline/math/so3.hpp>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::near;
using testing_support::pi;

/// exp(φ + t φ̇) as a jet in t at t = 0.
Motion motion_of(const Eigen::Vector3d& phi, const Eigen::Vector3d& rate) {
  using J = Jet<double, 3>;
  return motion_from_jet(exp<J>(constant<J>(phi) + constant<J>(rate) * J::variable(0.0)));
}

TEST(Jacobian, RightOneGivesTheBodyRate) {
  const Eigen::Vector3d rate(0.7, -0.3, 1.1);
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors())
    EXPECT_TRUE(near(right_jacobian<double>(phi) * rate, motion_of(phi, rate).angular_velocity, tolerance::algebra))
        << phi.transpose();
}

TEST(Jacobian, LeftOneGivesTheWorldRate) {
  const Eigen::Vector3d rate(0.7, -0.3, 1.1);
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors())
    EXPECT_TRUE(
        near(left_jacobian<double>(phi) * rate, angular_velocity_world(motion_of(phi, rate)), tolerance::algebra))
        << phi.transpose();
}

TEST(Jacobian, TimesItsInverseIsTheIdentity) {
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const double distance_to_singularity = 2 * pi - phi.stableNorm();
    const double allowed = tolerance::algebra / std::min(1.0, distance_to_singularity);
    const Eigen::Matrix3d right = right_jacobian<double>(phi) * right_jacobian_inverse<double>(phi);
    const Eigen::Matrix3d left = left_jacobian_inverse<double>(phi) * left_jacobian<double>(phi);
    EXPECT_LE((right - Eigen::Matrix3d::Identity()).norm(), allowed) << phi.transpose();
    EXPECT_LE((left - Eigen::Matrix3d::Identity()).norm(), allowed) << phi.transpose();
  }
}

TEST(Jacobian, AtZeroIsTheIdentity) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  EXPECT_EQ(right_jacobian<double>(zero), Eigen::Matrix3d::Identity());
  EXPECT_EQ(right_jacobian_inverse<double>(zero), Eigen::Matrix3d::Identity());
}

TEST(Jacobian, HasTheDerivativesOfTheAngularVelocity) {
  using J = Jet<double, 2>;
  const Eigen::Vector3d rate(0.7, -0.3, 1.1);
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    if (phi.stableNorm() > 2 * pi - 1e-3) continue;  // the jets of the sine lose digits, not the Jacobian
    const Vector3<J> moving = constant<J>(phi) + constant<J>(rate) * J::variable(0.0);
    const Vector3<J> omega = right_jacobian<J>(moving) * constant<J>(rate);
    const Motion wanted = motion_of(phi, rate);
    const auto order = [&omega](std::size_t k) {
      return Eigen::Vector3d(omega.x().derivative(k), omega.y().derivative(k), omega.z().derivative(k));
    };
    EXPECT_TRUE(near(order(1), wanted.angular_acceleration, tolerance::series)) << phi.transpose();
    EXPECT_TRUE(near(order(2), wanted.angular_jerk, tolerance::series)) << phi.transpose();
  }
}

}}  // namespace orispline
