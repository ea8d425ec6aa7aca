// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/continuity.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>

#include "tumbling_keys.hpp"

namespace orispline { namespace {

ShapeContinuity shape_of(std::string_view method, const Keyframes& keys) {
  return shape_continuity_at_keys(make_curve(method, keys).value());
}

TEST(ShapeContinuity, OfThePapersSplinesIsWhatTheyAreNamedByOnUnevenKeys) {
  const Keyframes keys = tumbling_keys(uneven_spacings);
  EXPECT_EQ(continuity_at_keys(make_curve("quintic", keys).value()).order(), 0);
  EXPECT_EQ(shape_of("quintic", keys).order(), 2);  // Tan et al. 2018
  EXPECT_EQ(shape_of("sextic", keys).order(), 3);
  EXPECT_EQ(shape_of("beta-g2", keys).order(), 2);
}

TEST(ShapeContinuity, IsAtLeastThatInTimeWhereTheBodyMoves) {
  const Keyframes keys = tumbling_keys(uneven_spacings);
  for (const FamilyInfo& family : families_info()) {
    const auto curve = make_curve(family.name, keys);
    ASSERT_TRUE(curve) << family.name;
    const ShapeContinuity shape = shape_continuity_at_keys(*curve);
    ASSERT_TRUE(shape.order()) << family.name;
    EXPECT_GE(*shape.order(), continuity_at_keys(*curve).order()) << family.name;
  }
}

TEST(ShapeContinuity, OfSlerpIsTheAngleOfTheCorner) {
  const auto keys = Keyframes::make({.times = {0.0, 1.0, 3.0},
                                     .orientations = {Eigen::Quaterniond::Identity(), exp<double>({0.5, 0.0, 0.0}),
                                                      exp<double>({0.5, 0.0, 0.0}) * exp<double>({0.0, 0.7, 0.0})}})
                        .value();
  const ShapeContinuity shape = shape_of("slerp", keys);
  EXPECT_NEAR(shape.direction.largest, std::sqrt(2.0), 1e-14);  // x before the key, y behind it
  EXPECT_EQ(shape.direction.key, 1u);
  EXPECT_EQ(shape.order(), 0);
}

TEST(ShapeContinuity, DoesNotSeeTheSpeedAboutOneAxis) {
  const auto about_z = [](double angle) { return exp<double>({0.0, 0.0, angle}); };
  const auto keys =
      Keyframes::make({.times = {0.0, 1.0, 1.5}, .orientations = {about_z(0.0), about_z(0.2), about_z(1.5)}}).value();
  EXPECT_EQ(continuity_at_keys(make_curve("slerp", keys).value()).order(), 0);
  EXPECT_EQ(shape_of("slerp", keys).order(), 3);
}

TEST(ShapeContinuity, OfOnePathAtTwoSpeedsIsTheSame) {
  Motion slow;
  slow.angular_velocity = {3.0, 0.0, 4.0};
  slow.angular_acceleration = {0.0, 6.0, 0.0};
  slow.angular_jerk = {-12.0, 0.0, 0.0};
  // The same path at time f(t) with f' = 2, f'' = 5, f''' = -7 at the joint, by the chain rule.
  Motion fast;
  fast.angular_velocity = 2.0 * slow.angular_velocity;
  fast.angular_acceleration = 4.0 * slow.angular_acceleration + 5.0 * slow.angular_velocity;
  fast.angular_jerk =
      8.0 * slow.angular_jerk + 3.0 * 2.0 * 5.0 * slow.angular_acceleration - 7.0 * slow.angular_velocity;
  const PathShape a = path_shape(slow), b = path_shape(fast);
  EXPECT_LE((a.direction - b.direction).norm(), 1e-15);
  EXPECT_LE((a.curvature - Eigen::Vector3d(0.0, 6.0 / 25.0, 0.0)).norm(), 1e-15);
  EXPECT_LE((a.curvature - b.curvature).norm(), 1e-15);
  EXPECT_LE((a.curvature_rate - Eigen::Vector3d(-12.0 / 125.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LE((a.curvature_rate - b.curvature_rate).norm(), 1e-15);
}

TEST(ShapeContinuity, IsUndefinedWhereTheBodyStandsStill) {
  auto keys = tumbling_keys({1.0, 1.0, 1.0, 1.0});
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0, 4.0}};
  for (const std::size_t i : {0u, 1u, 1u, 2u, 3u}) data.orientations.push_back(keys.orientations()[i]);
  const ShapeContinuity shape = shape_continuity_at_keys(
      make_curve(Method{"auto", {.parameters = {{"hold", {1.0}}}}}, Keyframes::make(std::move(data)).value()).value());
  EXPECT_EQ(shape.rests, 2u);  // both ends of the rest
  EXPECT_EQ(shape.first_rest, 1u);
  EXPECT_EQ(shape.stands, 2u);
  EXPECT_FALSE(shape.order());
  EXPECT_EQ(shape.order_in_motion(), 2);
}

Keyframes even_tumbling_keys() { return tumbling_keys({1.0, 1.0, 1.0, 1.0}); }

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Without tensions the quintic leaves a key about the increment behind it, and comes to it about the one before.
TEST(ShapeContinuity, OfAQuinticWithoutTensionsHasCornersBetweenItsIncrements) {
  const Keyframes keys = even_tumbling_keys();
  const auto increment = [&](std::size_t i) {
    return log<double>(keys.orientations()[i].conjugate() * keys.orientations()[i + 1]);
  };
  double widest = 0.0;
  for (std::size_t i = 0; i + 2 < keys.size(); ++i)
    widest = std::max(widest, angle_between(increment(i), increment(i + 1)));
  const auto curve = make_curve(Method{"quintic", {.parameters = {{"tension", {0.0}}}}}, keys);
  const ShapeContinuity shape = shape_continuity_at_keys(curve.value());
  EXPECT_EQ(continuity_at_keys(*curve).order(), 2);
  EXPECT_EQ(shape.order(), 0);
  EXPECT_FALSE(shape.order_in_motion());
  EXPECT_EQ(shape.rests, keys.size() - 2);
  EXPECT_EQ(shape.stands, 0u);
  EXPECT_NEAR(shape.corner().first, widest, 1e-12);
}

TEST(ShapeContinuity, OfAQuinticWithoutTensionAtAKeyHasACornerThereOnly) {
  const auto curve =
      make_curve(Method{"quintic", {.parameters = {{"tension", {0.35, 0.35, 0.0, 0.35, 0.35}}}}}, even_tumbling_keys());
  const ShapeContinuity shape = shape_continuity_at_keys(curve.value());
  EXPECT_EQ(shape.order(), 0);
  EXPECT_EQ(shape.order_in_motion(), 2);
  EXPECT_EQ(shape.rests, 1u);
  EXPECT_EQ(shape.corner().second, 2u);
  EXPECT_GT(shape.corner().first, 0.1);
}

// Its acceleration is 5/2 (b - a)/h² on both sides, so that it comes to rest and goes back.
TEST(ShapeContinuity, OfASexticWithoutTensionAtAKeyIsACusp) {
  const auto curve =
      make_curve(Method{"sextic", {.parameters = {{"tension", {0.08, 0.08, 0.0, 0.08, 0.08}}}}}, even_tumbling_keys());
  const ShapeContinuity shape = shape_continuity_at_keys(curve.value());
  EXPECT_EQ(continuity_at_keys(*curve).order(), 3);
  EXPECT_EQ(shape.order(), 0);
  EXPECT_EQ(shape.order_in_motion(), 3);
  EXPECT_NEAR(shape.corner().first, M_PI, 1e-7);
}

// With continuity and bias 1 a Kochanek–Bartels curve comes to rest at its key and leaves it at speed.
TEST(ShapeContinuity, OfABodyThatComesToRestAndLeavesAtSpeedIsTheCornerBetweenTheTwoDirections) {
  const Keyframes keys = even_tumbling_keys();
  const auto curve =
      make_curve(Method{"tcb", {.parameters = {{"continuity", {0, 0, 1, 0, 0}}, {"bias", {0, 0, 1, 0, 0}}}}}, keys);
  const double t = keys.times()[2];
  const Eigen::Vector3d leaving = curve.value().motion(t).angular_velocity;
  ASSERT_GT(leaving.norm(), 0.1);
  ASSERT_LT(curve->motion(t, Side::left).angular_velocity.norm(), 1e-12);
  const ShapeContinuity shape = shape_continuity_at_keys(*curve);
  EXPECT_EQ(shape.order(), 0);
  EXPECT_EQ(shape.rests, 1u);
  EXPECT_EQ(shape.corner().second, 2u);
  EXPECT_NEAR(shape.corner().first, angle_between(curve->motion(t - 1e-7).angular_velocity, leaving), 1e-5);
}

TEST(ShapeContinuity, CannotBeToldWhereTheBodyNearlyRests) {
  const auto curve =
      make_curve(Method{"sextic", {.parameters = {{"tension", {0.08, 0.08, 1e-6, 0.08, 0.08}}}}}, even_tumbling_keys());
  const ShapeContinuity shape = shape_continuity_at_keys(curve.value());
  EXPECT_TRUE(shape.is_hidden());
  EXPECT_EQ(shape.hidden_at, 2u);
  EXPECT_EQ(shape.order(), 1);
  EXPECT_EQ(shape.rests, 0u);
}

TEST(ShapeContinuity, IsToldOnShortSlowPaths) {
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0, 4.0}};
  for (const double x : {0.0, 1.0, 2.1, 3.3, 4.0})
    data.orientations.push_back(exp<double>({1e-5 * x, 1e-5 * x * x, 0.0}));
  const ShapeContinuity shape = shape_of("sextic", Keyframes::make(std::move(data)).value());
  EXPECT_FALSE(shape.is_hidden());
  EXPECT_EQ(shape.order(), 3);
}

TEST(ShapeContinuity, IsG1WhereTheBodyRestsAndGoesOnInTheSameDirection) {
  const auto about_z = [](double angle) { return exp<double>({0.0, 0.0, angle}); };
  const auto keys =
      Keyframes::make({.times = {0.0, 1.0, 2.0}, .orientations = {about_z(0.0), about_z(0.5), about_z(1.5)}}).value();
  const ShapeContinuity shape =
      shape_continuity_at_keys(make_curve(Method{"quintic", {.parameters = {{"tension", {0.0}}}}}, keys).value());
  EXPECT_EQ(shape.rests, 1u);
  EXPECT_EQ(shape.order(), 1);
  EXPECT_FALSE(shape.order_in_motion());
}

TEST(ShapeContinuity, OfACurveThatNeverMovesIsUndefined) {
  const Eigen::Quaterniond q = exp<double>({0.1, 0.2, 0.3});
  const auto keys = Keyframes::make({.times = {0.0, 1.0, 2.0}, .orientations = {q, q, q}}).value();
  const ShapeContinuity shape = shape_of("auto", keys);
  EXPECT_EQ(shape.rests, shape.joints);
  EXPECT_FALSE(shape.order_in_motion());
}

TEST(ShapeContinuity, OfALoopIncludesItsSeam) {
  const auto curve = make_curve(Method{"timed-c2", {.loop = Loop{.period = 6.0}}}, tumbling_keys(uneven_spacings));
  ASSERT_TRUE(curve);
  EXPECT_EQ(shape_continuity_at_keys(*curve, Seam::closed).joints, uneven_spacings.size() + 1);
  EXPECT_GE(*shape_continuity_at_keys(*curve, Seam::closed).order(), 2);
}

TEST(ShapeContinuity, ComesWithTheContinuityInTime) {
  const auto curve = make_curve("squad", tumbling_keys(uneven_spacings));
  const Continuity both = continuities_at_keys(*curve).in_time, alone = continuity_at_keys(*curve);
  for (const auto rate :
       {&Continuity::angular_velocity, &Continuity::angular_acceleration, &Continuity::angular_jerk}) {
    EXPECT_GT((both.*rate).largest, 0.0);
    EXPECT_EQ((both.*rate).largest, (alone.*rate).largest);
    EXPECT_EQ((both.*rate).key, (alone.*rate).key);
    EXPECT_EQ((both.*rate).magnitude, (alone.*rate).magnitude);
    EXPECT_EQ((both.*rate).relative, (alone.*rate).relative);
  }
}

}}  // namespace orispline
