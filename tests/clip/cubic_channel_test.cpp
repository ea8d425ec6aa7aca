// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr double degree = pi / 180.0;

AnyCurve curve_of(const char* method, const KeyframeData& data) {
  return make_curve(method, keyframes(data, Signs::shortest)).value();
}

KeyframeData flight() {
  const DataTable table("../../examples/data/flight_keys.csv");
  KeyframeData data;
  for (std::size_t i = 0; i < table.size(); ++i) {
    data.times.push_back(table.row(i).number("t"));
    data.orientations.push_back(table.row(i).quaternion("qw", "qx", "qy", "qz"));
  }
  return data;
}

/// At 37 places of every interval of the channel: no multiple of a 16th but its ends [rad].
double farthest(const AnyCurve& curve, const RotationChannel& channel) {
  const ChannelCurve<Eigen::Quaterniond> cubic(channel);
  double farthest = 0.0;
  for (const double t : sample_times(channel.times, 37))
    farthest = std::max(farthest, angular_distance(cubic.at(t), curve(t)));
  return farthest;
}

/// dq/dt = ½ q ω, written out.
Eigen::Quaterniond rate_of(const Eigen::Quaterniond& q, const Eigen::Vector3d& w) {
  return Eigen::Quaterniond(
      0.5 * (-q.x() * w.x() - q.y() * w.y() - q.z() * w.z()), 0.5 * (q.w() * w.x() + q.y() * w.z() - q.z() * w.y()),
      0.5 * (q.w() * w.y() + q.z() * w.x() - q.x() * w.z()), 0.5 * (q.w() * w.z() + q.x() * w.y() - q.y() * w.x()));
}

double apart(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return (a.coeffs() - b.coeffs()).norm(); }

TEST(CubicChannel, IsWithinTheToleranceAndNowhereFartherThanItSays) {
  for (const char* method : {"slerp", "auto", "squad", "timed-c2", "hermite-c1"})
    for (const double tolerance : {1.0 * degree, 0.01 * degree})
      for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
        const AnyCurve curve = curve_of(method, random_walk(7, 12, spacing));
        const auto found = cubic_channel(curve, tolerance);
        EXPECT_LE(found.largest_distance, tolerance) << method;
        EXPECT_LE(farthest(curve, found.channel), found.largest_distance * (1.0 + 1e-9)) << method;
        const ChannelCurve<Eigen::Quaterniond> cubic(found.channel);
        EXPECT_NEAR(angular_distance(cubic.at(found.largest_at), curve(found.largest_at)), found.largest_distance,
                    1e-12)
            << method;
      }
}

TEST(CubicChannel, HasKeysAtKnotsAndBetweenThemOnlyWhereItIsHalved) {
  const AnyCurve curve = curve_of("auto", random_walk(8, 10, Spacing::uneven));
  const RotationChannel channel = cubic_channel(curve, 0.02 * degree).channel;
  EXPECT_EQ(channel.interpolation, ChannelInterpolation::cubicspline);
  for (const double knot : curve.knots().times()) EXPECT_TRUE(std::ranges::binary_search(channel.times, knot));
  for (std::size_t i = 0; i < channel.size(); ++i) {
    EXPECT_LT(angular_distance(channel.values[i], curve(channel.times[i])), 1e-14);
    const KnotSpan span = curve.knots().span(curve.knots().segment_at(channel.times[i]));
    const double place = (channel.times[i] - span.start()) / span.step() * 0x1p20;
    EXPECT_NEAR(place, std::round(place), 1e-6);
  }
}

TEST(CubicChannel, HasTheRatesOfTheCurveAsTangentsOfKeysWithOneSign) {
  const AnyCurve curve = curve_of("auto", random_walk(9, 14, Spacing::uneven, 2.5));
  const RotationChannel channel = cubic_channel(curve, 0.05 * degree).channel;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const double t = channel.times[i];
    const Eigen::Quaterniond& q = channel.values[i];
    const Eigen::Quaterniond after = rate_of(q, curve.motion(t).angular_velocity);
    const Eigen::Quaterniond before = rate_of(q, curve.motion(t, Side::left).angular_velocity);
    EXPECT_LT(apart(channel.out_tangents[i], after), 1e-12) << i;
    EXPECT_LT(apart(channel.in_tangents[i], before), 1e-12) << i;
    EXPECT_GE(q.dot(channel.values[i - std::min<std::size_t>(i, 1)]), 0.0);
  }
}

TEST(CubicChannel, KeepsBothRatesWhereTheyJump) {
  const Eigen::Quaterniond turned = exp<double>(Eigen::Vector3d(1.0, 0.0, 0.0));
  const KeyframeData data{
      .times = {0.0, 1.0, 2.0},
      .orientations = {Eigen::Quaterniond::Identity(), turned, turned * exp<double>(Eigen::Vector3d(0.0, 2.0, 0.0))}};
  const RotationChannel channel = cubic_channel(curve_of("slerp", data), 0.001 * degree).channel;
  const auto at = static_cast<std::size_t>(std::ranges::find(channel.times, 1.0) - channel.times.begin());
  ASSERT_LT(at, channel.size());
  EXPECT_LT(apart(channel.in_tangents[at], rate_of(channel.values[at], {1.0, 0.0, 0.0})), 1e-14);
  EXPECT_LT(apart(channel.out_tangents[at], rate_of(channel.values[at], {0.0, 2.0, 0.0})), 1e-14);
}

TEST(CubicChannel, OfTheFlightHasNoMoreKeysThanStated) {
  const AnyCurve curve = curve_of("auto", flight());
  for (const auto& [tolerance, keys] :
       {std::pair(0.36, 40u), std::pair(0.03, 61u), std::pair(0.01, 91u), std::pair(0.0044, 118u)}) {
    const auto found = cubic_channel(curve, tolerance * degree);
    EXPECT_LE(found.channel.size(), keys) << tolerance;
    EXPECT_LE(farthest(curve, found.channel), tolerance * degree);
  }
}

TEST(CubicChannel, OfAPathHasItsVelocitiesAndIsWithinTheTolerance) {
  const PoseCurve curve = make_pose_curve("auto", keyframes(posed_walk(4, 11, Spacing::uneven))).value();
  const AnyPath& path = *curve.position;
  const double tolerance = 1e-4;
  const VectorChannel channel = cubic_channel(path, tolerance).channel;
  const ChannelCurve<Eigen::Vector3d> cubic(channel);
  double farthest = 0.0;
  for (const double t : sample_times(channel.times, 37))
    farthest = std::max(farthest, (cubic.at(t) - path.linear_motion(t).position).norm());
  EXPECT_LE(farthest, 1.02 * tolerance);
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const double t = channel.times[i];
    EXPECT_LT((channel.out_tangents[i] - path.linear_motion(t).velocity).norm(), 1e-12);
    EXPECT_LT((channel.in_tangents[i] - path.linear_motion(t, Side::left).velocity).norm(), 1e-12);
  }
}

TEST(CubicChannel, OfOneKeyIsThatKey) {
  const AnyCurve curve = curve_of("slerp", {.times = {3.0}, .orientations = {Eigen::Quaterniond(0.6, 0.0, 0.8, 0.0)}});
  const RotationChannel channel = cubic_channel(curve, 0.1).channel;
  ASSERT_EQ(channel.size(), 1u);
  EXPECT_EQ(channel.times[0], 3.0);
  EXPECT_LT(apart(channel.values[0], {0.6, 0.0, 0.8, 0.0}), 1e-15);
}

TEST(CubicChannel, OfStepsFollowsThemOutsideOfAShortTimeAndSaysHowFarItIs) {
  const Skeleton skeleton = Skeleton::make({{.name = "switch"}}).value();
  const auto about_x = [](double angle) { return exp<double>(Eigen::Vector3d(angle, 0.0, 0.0)); };
  const Clip clip{.name = "c",
                  .rotations = {{.interpolation = ChannelInterpolation::step,
                                 .times = {0.0, 1.0, 2.0, 3.0},
                                 .values = {about_x(0.0), about_x(1.0), about_x(0.5), about_x(0.5)}}}};
  const AnyCurve curve = joint_curve(skeleton, clip, 0, JointSpace::local).value().orientation;
  const auto found = cubic_channel(curve, 0.1 * degree);
  const ChannelCurve<Eigen::Quaterniond> cubic(found.channel);
  EXPECT_GT(found.largest_distance, 0.4);
  for (const double t : {0.0, 0.3, 0.999, 1.001, 1.5, 1.999, 2.001, 3.0})
    EXPECT_LT(angular_distance(cubic.at(t), curve(t)), 0.1 * degree) << t;
}

}}  // namespace orispline
