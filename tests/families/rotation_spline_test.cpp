// SPDX-License-Identifier: Apache-2.0
// rotation-spline: cubic rotation vectors, four kinds of ends, C2; not the same backwards.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/cubic_spline_by_definition.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

AnyCurve rotation_spline_curve(const KeyframeData& data, const End& start = {}, const End& end = {}) {
  return make_curve({"rotation-spline", {.start = start, .end = end}}, keyframes(data)).value();
}

Eigen::Vector3d secant(const KeyframeData& data, std::size_t i) {
  return increment<double>(data.orientations[i], data.orientations[i + 1]) / (data.times[i + 1] - data.times[i]);
}

TEST(RotationSpline, HasACubicRotationVectorFromEveryKey) {
  const KeyframeData data = random_walk(551, 8, Spacing::uneven);
  const AnyCurve c = rotation_spline_curve(data);
  for (std::size_t i = 0; i + 1 < data.times.size(); ++i) {
    const auto chart = [&](double u) -> Eigen::Vector3d {
      return increment<double>(data.orientations[i], c((1.0 - u) * data.times[i] + u * data.times[i + 1]));
    };
    const Eigen::Vector3d fourth = chart(0.1) - 4.0 * chart(0.3) + 6.0 * chart(0.5) - 4.0 * chart(0.7) + chart(0.9);
    const Eigen::Vector3d third = chart(0.1) - 3.0 * chart(0.3) + 3.0 * chart(0.5) - chart(0.7);
    EXPECT_LE(fourth.norm(), tolerance::series) << "segment " << i;
    EXPECT_GE(third.norm(), tolerance::visible_jump) << "segment " << i;
  }
}

TEST(RotationSpline, EndsWithTheRatesOfTheEndIncrementsByDefault) {
  const KeyframeData data = random_walk(552, 8, Spacing::uneven);
  const End secants{.rule = EndRule::secant};
  for (const AnyCurve& c : {rotation_spline_curve(data), rotation_spline_curve(data, secants, secants)}) {
    EXPECT_TRUE(near(c.motion(data.times.front()).angular_velocity, secant(data, 0), tolerance::series));
    EXPECT_TRUE(near(c.motion(data.times.back()).angular_velocity, secant(data, 6), tolerance::series));
  }
}

TEST(RotationSpline, HasTheGivenRatesAtClampedEnds) {
  const Eigen::Vector3d first(0.4, -1.2, 0.3), last(-0.7, 0.1, 2.0);
  const KeyframeData data = random_walk(553, 8, Spacing::uneven);
  const AnyCurve c = rotation_spline_curve(data, {EndRule::clamped, first}, {EndRule::clamped, last});
  EXPECT_TRUE(near(c.motion(data.times.front()).angular_velocity, first, tolerance::series));
  EXPECT_TRUE(near(c.motion(data.times.back()).angular_velocity, last, tolerance::series));
}

TEST(RotationSpline, StandsStillAtEndsAtRestAndDoesNotAccelerateAtNaturalOnes) {
  const KeyframeData data = random_walk(554, 8, Spacing::uneven);
  const AnyCurve rest = rotation_spline_curve(data, {.rule = EndRule::rest}, {.rule = EndRule::rest});
  const AnyCurve natural = rotation_spline_curve(data, {.rule = EndRule::natural}, {.rule = EndRule::natural});
  for (const double t : {data.times.front(), data.times.back()}) {
    EXPECT_LE(rest.motion(t).angular_velocity.norm(), tolerance::series);
    EXPECT_LE(natural.motion(t).angular_acceleration.norm(), tolerance::rates);
    EXPECT_GE(rotation_spline_curve(data).motion(t).angular_acceleration.norm(), 0.01);  // a secant end does accelerate
  }
}

TEST(RotationSpline, TakesARuleOfItsOwnAtEitherEnd) {
  const KeyframeData data = random_walk(555, 8, Spacing::uneven);
  const AnyCurve c = rotation_spline_curve(data, {.rule = EndRule::natural}, {.rule = EndRule::rest});
  EXPECT_LE(c.motion(data.times.front()).angular_acceleration.norm(), tolerance::rates);
  EXPECT_LE(c.motion(data.times.back()).angular_velocity.norm(), tolerance::series);
}

TEST(RotationSpline, IsC2OnLongTracksAtUnevenTimesWithWideTurns) {
  for (const double widest : {0.5, 1.5, 2.5}) {
    const auto jumps = relative_jumps(rotation_spline_curve(random_walk(556, 60, Spacing::uneven, widest)));
    for (const std::size_t order : {0u, 1u, 2u}) EXPECT_LE(jumps[order], tolerance::continuity) << widest;
    EXPECT_GE(jumps[3], tolerance::visible_jump) << widest;
  }
}

TEST(RotationSpline, OfTwoKeysIsTheGreatArcAtConstantRate) {
  const KeyframeData data = random_walk(557, 2, Spacing::even, 2.5);
  const Eigen::Vector3d rate = secant(data, 0);
  for (const EndRule rule : {EndRule::secant, EndRule::natural}) {
    const AnyCurve c = rotation_spline_curve(data, {.rule = rule}, {.rule = rule});
    for (const double t : sample_times(data.times, 7))
      EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << name_of(rule);
  }
}

TEST(RotationSpline, IsAnotherCurveBackwardsInTime) {
  const KeyframeData data = random_walk(558, 8, Spacing::even);
  const double distance =
      largest_distance_from_backwards(rotation_spline_curve(data), rotation_spline_curve(reversed(data)));
  EXPECT_GE(distance, tolerance::visible_jump);
  EXPECT_LE(distance, 0.3);
}

TEST(RotationSpline, IsTheSameOnAnotherClock) {
  const KeyframeData data = random_walk(559, 7, Spacing::uneven);
  KeyframeData rescaled = data;
  for (double& t : rescaled.times) t = 4.0 * t + 11.0;
  const AnyCurve c = rotation_spline_curve(data), d = rotation_spline_curve(rescaled);
  for (const double t : sample_times(data.times)) EXPECT_TRUE(near(d(4.0 * t + 11.0), c(t), tolerance::series)) << t;
}

TEST(RotationSpline, CarriesPositionsOnTheCubicSplineWithTheSameEnds) {
  const KeyframeData data = posed_walk(560, 8, Spacing::uneven);
  const auto velocity = [&](std::size_t i) -> Eigen::Vector3d {
    return (data.positions[i + 1] - data.positions[i]) / (data.times[i + 1] - data.times[i]);
  };
  using Ends = CubicSplineByDefinition::Ends;
  for (const auto& [rule, ends] :
       {std::pair{EndRule::secant, Ends{velocity(0), velocity(6)}}, std::pair{EndRule::natural, Ends{}},
        std::pair{EndRule::clamped, Ends{}},  // an angular rate: natural for positions
        std::pair{EndRule::rest, Ends{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}}}) {
    End end{.rule = rule};
    if (rule == EndRule::clamped) end.angular_velocity = {0.1, 0.2, 0.3};
    const PoseCurve pose = make_pose_curve({"rotation-spline", {.start = end, .end = end}}, keyframes(data)).value();
    const CubicSplineByDefinition spline(data.times, data.positions, ends);
    for (const double t : sample_times(data.times))
      EXPECT_TRUE(near(pose.position->linear_motion(t).position,
                       spline.derivative(0, t, pose.orientation.knots().segment_at(t)), tolerance::series))
          << name_of(rule);
  }
}

}}  // namespace orispline
