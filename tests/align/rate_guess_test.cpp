// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/align/rate_motion.hpp>
#include <orispline/families/registry.hpp>

#include "two_recordings.hpp"

namespace orispline { namespace {

using testing_support::TrueMotion;

AnyCurve curve_of(const std::function<Eigen::Quaterniond(double)>& orientation) {
  std::mt19937_64 random(4);
  return make_curve("slerp", testing_support::track_of({}, 0.0, orientation, TrueMotion::position, random).keys)
      .value();
}

/// ω of the body = B (ω of the gyro − correction), of which the guess knows nothing to begin with.
TEST(RateGuess, IsNearTheMountingAndTheBias) {
  const Eigen::Quaterniond mounting = Eigen::Quaterniond(0.2, 0.1, -0.7, 0.5).normalized();
  const AnyCurve body = curve_of(TrueMotion::orientation);
  const AnyCurve gyro = curve_of([&](double t) { return TrueMotion::orientation(t) * mounting; });
  const auto guess = guess_rates(gyro, body, 0.1, 0.0, true);
  ASSERT_TRUE(guess);
  EXPECT_LT(angular_distance(guess->body, mounting), 0.5);  // it begins with none: 2.7 away
  EXPECT_LT(guess->correction.norm(), 0.1);
  EXPECT_LT(disagreement(gyro, body, 0.1, *guess), 0.5);
}

}}  // namespace orispline
