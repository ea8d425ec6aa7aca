// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/smallest_ball.hpp>

#include <gtest/gtest.h>

#include "mean/set_of.hpp"

namespace orispline::mean_of { namespace {

using testing_support::base_pose;
using testing_support::degree;
using testing_support::normal_vector;
using testing_support::turned;

TEST(SmallestBall, OfTwoIsRoundTheirMiddle) {
  const Ball ball = smallest_ball(turned(base_pose, {{0, 0, 0}, {0, 0, 100}}).orientations);
  EXPECT_NEAR(ball.radius, 50.0 * degree, 1e-8);
  EXPECT_LT(angular_distance(ball.centre, turned(base_pose, {{0, 0, 50}}).orientations[0]), 1e-8);
}

TEST(SmallestBall, OfACubeHasItsCornersOnItsEdge) {
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-20.0, 20.0})
    for (const double y : {-20.0, 20.0})
      for (const double z : {-20.0, 20.0}) corners.emplace_back(x, y, z);
  corners.emplace_back(3.0, 5.0, 9.0);
  const Ball ball = smallest_ball(turned(base_pose, corners).orientations);
  EXPECT_NEAR(ball.radius, 20.0 * std::sqrt(3.0) * degree, 1e-8);
  EXPECT_LT(angular_distance(ball.centre, base_pose), 1e-8);
}

/// It holds all, and no centre nearby does better.
TEST(SmallestBall, IsSmallestAmongItsNeighbours) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 100; ++run) {
    std::vector<Eigen::Quaterniond> q;
    for (int k = 0; k < 2 + run % 40; ++k) q.push_back(base_pose * exp<double>(normal_vector(random, 0.3)));
    if (run % 2) q.push_back(Eigen::Quaterniond(-q.front().coeffs()));
    const Ball ball = smallest_ball(q);
    EXPECT_EQ(ball.radius, ball_round(ball.centre, q).radius);
    for (int k = 0; k < 50; ++k)
      EXPECT_GE(ball_round(ball.centre * exp<double>(normal_vector(random, std::pow(10.0, -1 - k % 5))), q).radius,
                ball.radius - 1e-9);
  }
}

TEST(SmallestBall, HoldsWhatIsAllAround) {
  std::mt19937_64 random(2);
  std::vector<Eigen::Quaterniond> q;
  for (int k = 0; k < 200; ++k) q.push_back(testing_support::any_orientation(random));
  EXPECT_GE(smallest_ball(q).radius, 0.5 * std::numbers::pi);
}

}}  // namespace orispline::mean_of
