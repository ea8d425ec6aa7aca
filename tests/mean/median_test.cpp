// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <support/near.hpp>

#include "mean/set_of.hpp"

namespace orispline { namespace {

using testing_support::any_orientation;
using testing_support::base_pose;
using testing_support::degree;
using testing_support::normal_vector;
using testing_support::SetOf;
using testing_support::turned;

/// Sum of the angles to an orientation.
double angles_to(const Eigen::Quaterniond& q, const SetOf& set) {
  double sum = 0.0;
  for (const auto& p : set.orientations) sum += angular_distance(q, p);
  return sum;
}

TEST(Median, OfOneAxisIsThatOfNumbers) {
  const auto found = turned(base_pose, {{0, 0, 0}, {0, 0, 10}, {0, 0, 100}}).median();
  ASSERT_TRUE(found);
  EXPECT_LT(angular_distance(found->orientation, turned(base_pose, {{0, 0, 10}}).orientations[0]), 1e-15);
  EXPECT_TRUE(found->certified);
  EXPECT_FALSE(found->covariance) << "nothing says how certain it is along the axis";
}

TEST(Median, IsTheMiddleOfARangeAndSaysSo) {
  const auto found = turned(base_pose, {{0, 0, -5}, {0, 0, 0}, {0, 0, 8}, {0, 0, 40}}).median();
  ASSERT_TRUE(found);
  EXPECT_LT(angular_distance(found->orientation, turned(base_pose, {{0, 0, 4}}).orientations[0]), 1e-15);
  EXPECT_FALSE(found->certified);
  EXPECT_NEAR(*found->others_within, 4.0 * degree, 1e-15);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_EQ(found->warnings[0].code, "median_of_a_range");
  const auto two = turned(base_pose, {{0, 0, 0}, {0, 0, 50}}).median();
  EXPECT_LT(angular_distance(two->orientation, turned(base_pose, {{0, 0, 25}}).orientations[0]), 1e-15);
}

TEST(Median, IsASampleWhoseWeightHoldsAgainstAllOthers) {
  SetOf set = turned(base_pose, {{3, 0, 0}, {0, 40, 0}, {0, 0, 50}, {-20, 30, 0}});
  set.weights = {3.5, 1.0, 1.0, 1.0};
  const auto found = set.median();
  ASSERT_TRUE(found);
  EXPECT_LT(angular_distance(found->orientation, set.orientations[0]), 1e-15);
  EXPECT_EQ(found->residual, 0.0);
  EXPECT_TRUE(found->certified);
  EXPECT_TRUE(found->covariance->allFinite());
}

/// No other point nearby has a smaller sum: what the gradient says, without it.
TEST(Median, HasTheLeastSumOfAngles) {
  std::mt19937_64 random(3);
  for (int run = 0; run < 50; ++run) {
    SetOf set;
    for (int k = 0; k < 3 + run % 9; ++k)
      set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.4)));
    const auto found = set.median();
    ASSERT_TRUE(found);
    EXPECT_LT(found->residual, 1e-13) << run;
    const double least = angles_to(found->orientation, set);
    for (int k = 0; k < 100; ++k)
      EXPECT_GE(angles_to(found->orientation * exp<double>(normal_vector(random, std::pow(10.0, -1 - k % 5))), set),
                least - 1e-14);
  }
}

TEST(Median, IsHardlyMovedByHalfOfTheRowsBeingBad) {
  std::mt19937_64 random(4);
  for (int run = 0; run < 20; ++run) {
    SetOf set;
    for (int k = 0; k < 51; ++k) set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.01)));
    for (int k = 0; k < 49; ++k) set.orientations.push_back(any_orientation(random));
    const auto median = set.median(), mean = set.mean();
    ASSERT_TRUE(median && mean);
    EXPECT_LT(angular_distance(median->orientation, base_pose), 0.6 * degree);
    EXPECT_GT(angular_distance(mean->orientation, base_pose), 4.0 * degree);
  }
}

TEST(Median, StaysWhereMostAreWhenTheOthersAgree) {
  const Eigen::Quaterniond elsewhere = base_pose * exp<double>(Eigen::Vector3d(0.4, 1.9, -0.8));
  std::mt19937_64 random(5);
  SetOf set;
  for (int k = 0; k < 49; ++k) set.orientations.push_back(elsewhere * exp<double>(normal_vector(random, 0.01)));
  for (int k = 0; k < 51; ++k) set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.01)));
  EXPECT_LT(angular_distance(set.median()->orientation, base_pose), 3.0 * degree);
}

TEST(Median, ProvesThatItIsTheOnlyOneThoughSomeAreFarAway) {
  SetOf set =
      turned(base_pose, {{1, 0, 0}, {-1, 1, 0}, {0, -1, 1}, {0, 0.5, -1}, {0.5, 0.5, 0.2}, {0, 0, 170}, {0, -150, 60}});
  const auto found = set.median();
  ASSERT_TRUE(found);
  EXPECT_GT(found->ball_radius, 90.0 * degree);
  EXPECT_TRUE(found->certified);
  EXPECT_EQ(found->others_within, 0.0);
  set.orientations.push_back(base_pose * exp<double>(Eigen::Vector3d(0.0, 3.14, 0.0)));
  const auto near_half_turn = set.median();
  EXPECT_FALSE(near_half_turn->certified);
  EXPECT_LT(*near_half_turn->others_within, 20.0 * degree);
  EXPECT_GT(*near_half_turn->others_within, 0.0);
}

TEST(Median, OfPositionsIsTheGeometricOne) {
  // The point from which the corners of a triangle are 120° apart: of (0, 0), (1, 0) and (1/2, h) it is on the line
  // x = 1/2 at 1/(2 √3).
  SetOf set = turned(base_pose, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  set.positions = {{0, 0, 5}, {1, 0, 5}, {0.5, 0.8, 5}};
  const auto found = set.median();
  ASSERT_TRUE(found);
  EXPECT_LT((*found->position - Eigen::Vector3d(0.5, 0.5 / std::sqrt(3.0), 5.0)).norm(), 1e-15);
  EXPECT_LT((*set.mean()->position - Eigen::Vector3d(0.5, 0.8 / 3.0, 5.0)).norm(), 1e-15);
  set.positions = {{0, 0, 5}, {0, 0, 5}, {0.5, 0.8, 5}};
  EXPECT_EQ(*set.median()->position, Eigen::Vector3d(0, 0, 5));
}

}}  // namespace orispline
