// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/distance.hpp>

#include <gtest/gtest.h>

#include <orispline/analysis/sampled.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::about_x;

/// Turns about x at 1 rad/s from 0 to 2 s.
AnyCurve steady_turn() {
  return make_curve("slerp", Keyframes::make(
                                 {.times = {0.0, 1.0, 2.0}, .orientations = {about_x(0.0), about_x(1.0), about_x(2.0)}})
                                 .value())
      .value();
}

TEST(Distance, IsTheRootMeanSquareTheMeanAndTheLargestAngle) {
  const std::vector<double> times{0.0, 0.5, 1.5, 2.0};
  const std::vector<Eigen::Quaterniond> reference{about_x(0.0), about_x(0.8), about_x(1.1), about_x(2.0)};

  const DistanceStatistics d = distance_to_reference(steady_turn(), {times, reference});

  EXPECT_EQ(d.count, 4u);
  EXPECT_NEAR(d.rms, 0.25, 1e-15);  // distances 0, 0.3, 0.4, 0
  EXPECT_NEAR(d.mean, 0.175, 1e-15);
  EXPECT_NEAR(d.largest, 0.4, 1e-15);
  EXPECT_EQ(d.largest_at, 2u);
}

TEST(Distance, TakesBothSignsOfAQuaternionForOneOrientation) {
  const std::vector<double> times{1.0};
  const std::vector<Eigen::Quaterniond> reference{Eigen::Quaterniond(-about_x(1.0).coeffs())};
  EXPECT_NEAR(distance_to_reference(steady_turn(), {times, reference}).largest, 0.0, 1e-15);
}

TEST(Distance, LeavesOutTimesBeyondTheCurve) {
  const std::vector<double> times{-0.1, 1.0, 2.1};
  const std::vector<Eigen::Quaterniond> reference{about_x(3.0), about_x(1.2), about_x(3.0)};

  const DistanceStatistics d = distance_to_reference(steady_turn(), {times, reference});

  EXPECT_EQ(d.count, 1u);
  EXPECT_NEAR(d.largest, 0.2, 1e-15);
  EXPECT_EQ(d.largest_at, 1u);
}

TEST(Distance, HasPercentilesBetweenTheNeighboursInRisingOrder) {
  const DistanceStatistics d = distance_statistics({4.0, 1.0, 3.0, 2.0, 5.0}, 10);
  EXPECT_EQ(d.median, 3.0);
  EXPECT_NEAR(d.percentile_95, 4.8, 1e-15);  // as numpy.percentile
  EXPECT_NEAR(d.percentile_99, 4.96, 1e-15);
  EXPECT_EQ(d.largest_at, 14u);
  EXPECT_NEAR(d.mean_square(), 11.0, 1e-14);
}

TEST(Distance, OnTheSphereOfQuaternionsIsHalfTheAngle) {
  EXPECT_NEAR(spherical_distance(about_x(0.2), Eigen::Quaterniond(-about_x(1.0).coeffs())), 0.4, 1e-15);
}

TEST(RateError, IsTheLengthOfTheDifferenceWithinTheDomain) {
  const std::vector<double> times{-1.0, 0.5, 1.5, 2.0};
  const std::vector<Eigen::Vector3d> logged{{9, 9, 9}, {1.0, 0.3, 0.4}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};

  const DistanceStatistics d = rate_error(steady_turn(), {times, logged});

  EXPECT_EQ(d.count, 3u);
  EXPECT_NEAR(d.largest, 0.5, 1e-15);
  EXPECT_EQ(d.largest_at, 1u);
  EXPECT_NEAR(d.rms, 0.5 / std::sqrt(3.0), 1e-15);
}

TEST(RateError, TakesTheMeanOfBothSidesWhereTheRateJumps) {
  const auto keys =
      Keyframes::make({.times = {0.0, 1.0, 3.0}, .orientations = {about_x(0.0), about_x(0.8), about_x(1.2)}}).value();
  const std::vector<double> times{1.0};
  const std::vector<Eigen::Vector3d> logged{{0.5, 0.0, 0.0}};
  EXPECT_NEAR(rate_error(make_curve("slerp", keys).value(), {times, logged}).rms, 0.0, 1e-15);  // 0.8 and 0.2
}

TEST(Distance, OfNothingIsZero) {
  const DistanceStatistics d = distance_to_reference(steady_turn(), {});
  EXPECT_EQ(d.count, 0u);
  EXPECT_EQ(d.rms, 0.0);
  EXPECT_EQ(rate_error(steady_turn(), {}).count, 0u);
  const SampledCurve none = sampled(steady_turn(), {}, Sampled::orientations_and_rates);
  EXPECT_TRUE(none.orientations.empty() && none.angular_velocities.empty());
}

}}  // namespace orispline
