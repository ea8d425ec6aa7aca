// SPDX-License-Identifier: Apache-2.0
// slerp and squad with their derivatives, equation by equation of Eberly's text (corrected).
#include <orispline/math/geodesic.hpp>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::near;

class FourQuaternions : public testing::Test {
 protected:
  using Jet3 = Jet<double, 3>;

  [[nodiscard]] Motion slerp_motion(double s) const {
    return motion_from_jet(slerp<Jet3>(constant<Jet3>(p), constant<Jet3>(q), Jet3::variable(s)));
  }
  [[nodiscard]] Motion squad_motion(double s) const {
    return motion_from_jet(
        squad<Jet3>(constant<Jet3>(p), constant<Jet3>(a), constant<Jet3>(b), constant<Jet3>(q), Jet3::variable(s)));
  }

  const Eigen::Quaterniond p = exp<double>(Eigen::Vector3d(0.3, -0.5, 0.8));
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(-0.9, 0.4, 1.2));
  const Eigen::Quaterniond a = exp<double>(Eigen::Vector3d(0.1, 0.2, 1.1));
  const Eigen::Quaterniond b = exp<double>(Eigen::Vector3d(-0.4, -0.3, 0.7));
};
class Slerp : public FourQuaternions {};
class Squad : public FourQuaternions {};

TEST_F(Slerp, BeginsAndEndsAtTheGivenQuaternions) {
  EXPECT_TRUE(near(slerp<double>(p, q, 0.0), p, tolerance::exact));
  EXPECT_TRUE(near(slerp<double>(p, q, 1.0), q, tolerance::exact));
}

TEST_F(Slerp, HasTheSineForm) {
  const double angle = std::acos(p.dot(q));
  for (const double s : {-0.5, 0.2, 0.5, 0.9, 1.5}) {
    const Eigen::Vector4d wanted =
        (std::sin((1 - s) * angle) * p.coeffs() + std::sin(s * angle) * q.coeffs()) / std::sin(angle);
    EXPECT_TRUE(near(slerp<double>(p, q, s).coeffs(), wanted, tolerance::algebra)) << s;
  }
}

TEST_F(Slerp, MovesAtTheConstantRateOfItsIncrement) {
  for (const double s : {-0.5, 0.0, 0.3, 1.0}) {
    const Motion m = slerp_motion(s);
    EXPECT_TRUE(near(m.angular_velocity, increment<double>(p, q), tolerance::algebra));
    EXPECT_TRUE(near(m.angular_acceleration, Eigen::Vector3d::Zero(), tolerance::algebra));
    EXPECT_TRUE(near(m.angular_jerk, Eigen::Vector3d::Zero(), tolerance::algebra));
  }
}

TEST_F(Slerp, TakesTheSignsItIsGiven) {
  const Eigen::Quaterniond opposite(-q.w(), -q.x(), -q.y(), -q.z());

  const double the_long_way = increment<double>(p, opposite).norm();

  EXPECT_NEAR(the_long_way, 2 * testing_support::pi - increment<double>(p, q).norm(), tolerance::algebra);
  EXPECT_TRUE(near(slerp<double>(p, opposite, 1.0), opposite, tolerance::exact));
  EXPECT_GT(angular_distance(slerp<double>(p, opposite, 0.5), slerp<double>(p, q, 0.5)), 3.0);
}

TEST_F(Slerp, IsTheSameFromEitherEnd) {
  for (const double s : {0.1, 0.5, 0.8})
    EXPECT_TRUE(near(slerp<double>(p, q, s), slerp<double>(q, p, 1.0 - s), tolerance::algebra));
}

TEST_F(Slerp, BetweenEqualQuaternionsStaysThere) { EXPECT_TRUE(near(slerp<double>(p, p, 0.4), p, tolerance::exact)); }

TEST_F(Squad, IsSlerpOfSlerps) {
  for (const double s : {0.0, 0.25, 0.6, 1.0}) {
    const Eigen::Quaterniond wanted =
        slerp<double>(slerp<double>(p, q, s), slerp<double>(a, b, s), 2.0 * s * (1.0 - s));
    EXPECT_TRUE(near(squad<double>(p, a, b, q, s), wanted, tolerance::exact));
  }
}

TEST_F(Squad, LeavesAndArrivesWithTheEndDerivativesOfEquation20) {
  // S'(0) = p (log(p⁻¹q) + 2 log(p⁻¹a)), S'(1) = q (log(p⁻¹q) - 2 log(q⁻¹b)); ω = 2 q̄q'.
  EXPECT_TRUE(near(squad_motion(0.0).angular_velocity, increment<double>(p, q) + 2.0 * increment<double>(p, a),
                   tolerance::algebra));
  EXPECT_TRUE(near(squad_motion(1.0).angular_velocity, increment<double>(p, q) - 2.0 * increment<double>(q, b),
                   tolerance::algebra));
}

TEST_F(Squad, HasTheRatesOfItsOwnDifferences) {
  const double h = tolerance::difference_step;
  for (const double s : {0.2, 0.5, 0.9}) {
    const Motion before = squad_motion(s - h), here = squad_motion(s), after = squad_motion(s + h);
    EXPECT_TRUE(near(increment<double>(before.orientation, after.orientation) / (2 * h), here.angular_velocity,
                     tolerance::difference));
    EXPECT_TRUE(near((after.angular_velocity - before.angular_velocity) / (2 * h), here.angular_acceleration,
                     tolerance::difference));
    EXPECT_TRUE(near((after.angular_acceleration - before.angular_acceleration) / (2 * h), here.angular_jerk,
                     tolerance::difference));
  }
}

TEST_F(Squad, WithTheKeysAsInnerPointsIsSlerp) {
  for (const double s : {0.1, 0.5, 0.7})
    EXPECT_TRUE(near(squad<double>(p, p, q, q, s), slerp<double>(p, q, s), tolerance::algebra));
}

}}  // namespace orispline
