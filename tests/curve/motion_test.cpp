// SPDX-License-Identifier: Apache-2.0
// Body and world rates of motions known in closed form.
#include <orispline/curve/motion.hpp>

#include <gtest/gtest.h>

#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::near;
using J = Jet<double, 3>;

/// A rotation by angle(t) about a fixed axis, then by t about the body's z.
Quaternion<J> coning(double t) {
  const J time = J::variable(t);
  return exp<J>(constant<J>(Eigen::Vector3d(0.8, 0, 0)) * (time * time)) *
         exp<J>(constant<J>(Eigen::Vector3d(0, 0, 1)) * time);
}

TEST(Motion, OfASpinAboutAFixedAxisHasTheDerivativesOfTheAngle) {
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  const J t = J::variable(0.7);
  const Motion m = motion_from_jet(exp<J>(constant<J>(axis) * (0.5 * t + 2.0 * t * t + t * t * t)));
  EXPECT_TRUE(near(m.angular_velocity, (0.5 + 4 * 0.7 + 3 * 0.49) * axis, tolerance::algebra));
  EXPECT_TRUE(near(m.angular_acceleration, (4 + 6 * 0.7) * axis, tolerance::algebra));
  EXPECT_TRUE(near(m.angular_jerk, 6 * axis, tolerance::series));
}

TEST(Motion, HasBodyRatesByDefault) {
  // q = Rx(0.8 t²) Rz(t): ω_body = Rz(t)ᵀ (1.6 t, 0, 0) + (0, 0, 1).
  const double t = 0.6, c = std::cos(t), s = std::sin(t);
  const Motion m = motion_from_jet(coning(t));
  EXPECT_TRUE(near(m.angular_velocity, Eigen::Vector3d(1.6 * t * c, -1.6 * t * s, 1), tolerance::algebra));
  EXPECT_TRUE(
      near(m.angular_acceleration, Eigen::Vector3d(1.6 * (c - t * s), -1.6 * (s + t * c), 0), tolerance::algebra));
  EXPECT_TRUE(
      near(m.angular_jerk, Eigen::Vector3d(1.6 * (-2 * s - t * c), -1.6 * (2 * c - t * s), 0), tolerance::algebra));
}

TEST(Motion, HasWorldRatesOnRequest) {
  // ω_world = (1.6 t, 0, 0) + Rx(0.8 t²) (0, 0, 1).
  const double t = 0.6, a = 0.8 * t * t, b = 1.6 * t, c = std::cos(a), s = std::sin(a);
  const Motion m = motion_from_jet(coning(t));
  EXPECT_TRUE(near(angular_velocity_world(m), Eigen::Vector3d(b, -s, c), tolerance::algebra));
  EXPECT_TRUE(near(angular_acceleration_world(m), Eigen::Vector3d(1.6, -b * c, -b * s), tolerance::algebra));
  EXPECT_TRUE(
      near(angular_jerk_world(m), Eigen::Vector3d(0, -1.6 * c + b * b * s, -1.6 * s - b * b * c), tolerance::algebra));
}

}}  // namespace orispline
