// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/math/gauss_legendre.hpp>
#include <support/random_motion.hpp>

namespace orispline { namespace {

Keyframes turning_keys() {
  KeyframeData data{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (const auto& [seconds, turn] : {std::pair(1.0, Eigen::Vector3d(0.6, 0.0, 0.0)),
                                      {2.0, {0.0, 0.8, 0.0}},
                                      {0.5, {0.0, 0.0, -0.2}},
                                      {1.0, {0.0, 0.0, 0.0}},
                                      {1.0, {0.1, 0.2, 0.2}}}) {
    data.times.push_back(data.times.back() + seconds);
    data.orientations.push_back(data.orientations.back() * exp<double>(turn));
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(AngleTravelled, OfSlerpsIsTheSumOfTheSteps) {
  const AngleTravelled travelled(make_curve("slerp", turning_keys()).value());
  EXPECT_NEAR(travelled.total(), 0.6 + 0.8 + 0.2 + 0.0 + 0.3, 1e-14);
  EXPECT_NEAR(travelled.at(2.0), 0.6 + 0.4, 1e-14);
  EXPECT_EQ(travelled.at(-1.0), 0.0);
  EXPECT_EQ(travelled.at(9.0), travelled.total());
}

TEST(AngleTravelled, HasTheFirstTimeOfAnAngleForItsInverse) {
  const AngleTravelled travelled(make_curve("slerp", turning_keys()).value());
  EXPECT_NEAR(travelled.time_at(1.0), 2.0, 1e-12);
  EXPECT_NEAR(travelled.time_at(1.6), 3.5, 1e-12);  // then it rests for a second
  EXPECT_EQ(travelled.time_at(-1.0), 0.0);
  EXPECT_NEAR(travelled.time_at(9.0), 5.5, 1e-12);
}

TEST(AngleTravelled, IsTheIntegralOfTheSpeedAndInvertsItself) {
  const AnyCurve curve = make_curve("auto", turning_keys()).value();
  const AngleTravelled travelled(curve);
  double polygon = 0.0;
  constexpr int steps = 20000;
  for (int k = 0; k < steps; ++k)
    polygon += angular_distance(curve(5.5 * k / steps), curve(5.5 * (k + 1) / steps));  // short by O(steps^-2)
  EXPECT_NEAR(travelled.total(), polygon, 1e-6);
  for (const double part : {0.1, 0.37, 0.5, 0.93}) {
    const double angle = part * travelled.total();
    EXPECT_NEAR(travelled.at(travelled.time_at(angle)), angle, 1e-10);
  }
}

/// By Gauss's rule on many even pieces of a segment.
double travelled_in_pieces(const AnyCurve& curve, std::size_t segment, int pieces) {
  const auto rule = gauss_legendre<24>();
  const KnotSpan span = curve.knots().span(segment);
  const double piece = (span.end() - span.start()) / pieces;
  double angle = 0.0;
  for (int k = 0; k < pieces; ++k)
    for (const auto& [u, weight] : rule)
      angle += piece * weight * curve.motion_on(segment, span.start() + piece * (k + u)).angular_velocity.norm();
  return angle;
}

TEST(AngleTravelled, IsExactWhereTheRateComesNearZeroInSpikes) {
  // Of steps that differ 89 times this one turns fourteen times, in jerks.
  const AnyCurve curve = make_curve("barry-goldman", random_keys(35, {9, 3.0, 89.0})).value();
  constexpr std::size_t segment = 6;
  const KnotSpan span = curve.knots().span(segment);
  const AngleTravelled travelled(curve);
  const double wanted = travelled_in_pieces(curve, segment, 1500);
  EXPECT_NEAR((travelled.at(span.end()) - travelled.at(span.start())) / wanted, 1.0, 1e-12);
}

TEST(AngleTravelled, OfOneKeyIsNone) {
  const auto key = Keyframes::make({.times = {4.0}, .orientations = {Eigen::Quaterniond::Identity()}}).value();
  const AngleTravelled travelled(make_curve("slerp", key).value());
  EXPECT_EQ(travelled.total(), 0.0);
  EXPECT_EQ(travelled.time_at(1.0), 4.0);
}

TEST(DistanceTravelled, IsThatOfThePositionsAndInvertsItself) {
  const auto keys = Keyframes::make({.times = {0.0, 1.0, 3.0},
                                     .orientations = std::vector(3, Eigen::Quaterniond::Identity()),
                                     .positions = {{0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}, {3.0, 4.0, 12.0}}})
                        .value();
  const DistanceTravelled travelled(make_pose_curve("slerp", keys).value().position.value());
  EXPECT_NEAR(travelled.total(), 17.0, 1e-13);
  EXPECT_NEAR(travelled.at(2.0), 11.0, 1e-13);
  EXPECT_NEAR(travelled.time_at(2.5), 0.5, 1e-13);
}

}}  // namespace orispline
