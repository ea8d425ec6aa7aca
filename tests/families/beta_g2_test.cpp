// SPDX-License-Identifier: Apache-2.0
// The Beta curves that are truly G2: the residuals of both constraints, what the correction leaves alone, ends,
// refusals.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/beta_joints.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::BetaG2;

CurveOptions options(const std::string& form, const Parameters& betas) {
  return {.parameters = betas, .choices = {{"form", form}}};
}

/// The index of the key that a joint belongs to.
std::size_t key_of_joint(const std::string& form, std::size_t joint) { return form == "local" ? joint + 1 : joint; }

class BetaG2Forms : public testing::TestWithParam<std::string> {};

TEST_P(BetaG2Forms, FulfilBothConstraintsForMixedBetas) {
  for (const std::uint64_t seed : {421u, 422u, 423u}) {
    const Parameters betas = mixed_betas(9, seed);
    const Keyframes keys = keyframes(at_whole_times(random_walk(seed + 10, 9, Spacing::even)));
    const auto curve = typed_curve<BetaG2>(keys, options(GetParam(), betas));
    for (std::size_t joint = 1; joint < curve.knots().segments(); ++joint) {
      const std::size_t key = key_of_joint(GetParam(), joint);
      const double beta1 = betas.at("beta1")[key], beta2 = betas.at("beta2")[key];
      const Joint j = joint_of(curve, joint);
      EXPECT_LE((j.after1 - beta1 * j.before1).norm(), tolerance::series * j.after1.norm());
      EXPECT_LE(relative_g2_residual(j, beta1, beta2), tolerance::series) << "joint " << joint;
    }
  }
}

TEST_P(BetaG2Forms, StayG2WithOtherRatiosOnUnevenTimes) {
  // Segments stretched in time: s' = h ṡ, s'' = h² s̈ fulfil the same constraints.
  const Parameters betas = mixed_betas(8, 424);
  const Keyframes keys = keyframes(random_walk(425, 8, Spacing::uneven));
  const auto curve = typed_curve<BetaG2>(keys, options(GetParam(), betas));
  for (std::size_t joint = 1; joint < curve.knots().segments(); ++joint) {
    const std::size_t key = key_of_joint(GetParam(), joint);
    const double before = curve.knots().span(joint - 1).step(), after = curve.knots().span(joint).step();
    Joint j = joint_of(curve, joint);
    j.before1 *= before;
    j.before2 *= before * before;
    j.after2 *= after * after;
    EXPECT_LE(relative_g2_residual(j, betas.at("beta1")[key], betas.at("beta2")[key]), tolerance::series);
  }
}

TEST_P(BetaG2Forms, RefusePolesWithTheKey) {
  const Keyframes keys = keyframes(random_walk(426, 5, Spacing::even));
  const auto c = make_curve({"beta-g2", options(GetParam(), {{"beta2", {0, 0, 0, -4, 0}}})}, keys);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(c.error().where.key, 3u);
  EXPECT_NE(c.error().message.find("beta-g2: beta2 is -4, wanted more than"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Form, BetaG2Forms, testing::Values("local", "global"),
                         [](const auto& test) { return test.param; });

TEST(BetaG2Local, CorrectsThePublishedCurveWhichIsNotG2) {
  const Parameters betas = mixed_betas(9, 421);
  const Keyframes keys = keyframes(at_whole_times(random_walk(431, 9, Spacing::even)));
  const CubicBezierCurve published = beta(keys, betas);
  for (std::size_t joint = 1; joint < published.knots().segments(); ++joint) {
    const double beta1 = betas.at("beta1")[joint + 1], beta2 = betas.at("beta2")[joint + 1];
    EXPECT_GT(relative_g2_residual(joint_of(published, joint), beta1, beta2), 1e-3);
  }
}

TEST(BetaG2Local, LeavesTheFirstSegmentAndAllJointsAndTheirRatesAsPublished) {
  const Parameters betas = mixed_betas(8, 432);
  const Keyframes keys = keyframes(random_walk(433, 8, Spacing::uneven));
  const AnyCurve corrected = make_curve({"beta-g2", {.parameters = betas}}, keys).value();
  const AnyCurve published = make_curve({"beta", {.parameters = betas}}, keys).value();
  const auto knots = published.knots().times();
  for (const double t : sample_times(knots.first(2), 8))
    EXPECT_TRUE(near(corrected(t), published(t), tolerance::algebra));
  for (const double t : knots) {
    const Motion m = corrected.motion(t), wanted = published.motion(t);
    EXPECT_TRUE(near(m.orientation, wanted.orientation, tolerance::algebra));
    EXPECT_TRUE(near(m.angular_velocity, wanted.angular_velocity, tolerance::series));
  }
  EXPECT_GT(angular_distance(corrected(0.5 * (knots[2] + knots[3])), published(0.5 * (knots[2] + knots[3]))), 1e-5);
}

TEST(BetaG2Global, PassesThroughItsKeys) {
  const Keyframes keys = keyframes(random_walk(434, 9, Spacing::uneven));
  const AnyCurve c = make_curve({"beta-g2", options("global", mixed_betas(9, 435))}, keys).value();
  EXPECT_EQ(c.domain().start, keys.times().front());
  EXPECT_EQ(c.domain().end, keys.times().back());
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(c.motion(keys.times()[i], side).orientation, keys.orientations()[i], tolerance::algebra));
}

TEST(BetaG2Global, StartsAndEndsWithTheRateOfTheEndIncrements) {
  const Keyframes keys = keyframes(at_whole_times(random_walk(436, 6, Spacing::even)));
  const auto q = keys.orientations();
  const Parameters betas = mixed_betas(6, 437);
  const AnyCurve c = make_curve({"beta-g2", options("global", betas)}, keys).value();
  EXPECT_TRUE(near(c.motion(0).angular_velocity, Eigen::Vector3d(betas.at("beta1")[0] * increment<double>(q[0], q[1])),
                   tolerance::series));
  EXPECT_TRUE(near(c.motion(5).angular_velocity, increment<double>(q[4], q[5]), tolerance::series));
}

TEST(BetaG2Global, OfPositionsFulfilsBarskysConstraints) {
  KeyframeData data = at_whole_times(random_walk(438, 7, Spacing::even));
  Dice dice(439);
  for (std::size_t i = 0; i < 7; ++i) data.positions.push_back(3.0 * dice.vector());
  const Parameters betas = mixed_betas(7, 440);
  const PoseCurve pose = make_pose_curve({"beta-g2", options("global", betas)}, keyframes(data)).value();
  for (std::size_t i = 1; i < 6; ++i) {
    const double beta1 = betas.at("beta1")[i], beta2 = betas.at("beta2")[i];
    const LinearMotion before = pose.position->linear_motion(data.times[i], Side::left),
                       after = pose.position->linear_motion(data.times[i]);
    EXPECT_TRUE(near(after.position, data.positions[i], tolerance::algebra));
    EXPECT_TRUE(near(after.velocity, Eigen::Vector3d(beta1 * before.velocity), tolerance::series));
    EXPECT_TRUE(near(after.acceleration, Eigen::Vector3d(beta1 * beta1 * before.acceleration + beta2 * before.velocity),
                     tolerance::series));
  }
}

TEST(BetaG2Global, HasNoHandleLongerThanHalfATurnOnEitherSideOfAKey) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 442; seed < 472; ++seed) {
    const Keyframes keys = keyframes(random_walk(seed, 5, Spacing::even, 2.5));
    const auto c = make_curve({"beta-g2", options("global", {{"beta1", {4.0}}})}, keys);
    if (!c) {
      ++refused;
      continue;
    }
    for (std::size_t i = 0; i < keys.size(); ++i)
      for (const Side side : {Side::left, Side::right}) {
        const double third = 0.5 / 3.0;  // of a step
        EXPECT_LT(third * c->motion(keys.times()[i], side).angular_velocity.norm(), pi) << seed << ", key " << i;
      }
  }
  EXPECT_GT(refused, 0u);
  EXPECT_LT(refused, 30u);
}

TEST(BetaG2Global, TellsWhereItsEquationsHaveNoSolution) {
  KeyframeData data = at_whole_times(random_walk(441, 6, Spacing::even));
  for (std::size_t i = 0; i < 6; ++i)
    data.orientations[i] = exp<double>(i % 2 == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(5.5, 0, 0));
  const auto c = make_curve({"beta-g2", options("global", {{"beta1", {0.05}}})}, keyframes(data));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::not_converged);
  EXPECT_LT(c.error().where.key.value(), 6u);
}

}}  // namespace orispline
