// SPDX-License-Identifier: Apache-2.0
// The Beta curve through its keys: what is solved for, what stays of the published one, what is refused.
#include <limits>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/beta_joints.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::BetaThrough;

double gamma_of(const Parameters& betas, std::size_t i) {
  const double b1 = betas.at("beta1")[i];
  return 2.0 * (1.0 + b1) / (betas.at("beta2")[i] + 2.0 * b1 * (1.0 + b1));
}

TEST(BetaThrough, PassesThroughItsKeysForMixedBetas) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven})
    for (const std::size_t more : {0u, 2u}) {
      const Keyframes keys = keyframes(random_walk(401, 9, spacing));
      const AnyCurve c = make_curve({"beta-through", {.parameters = mixed_betas(9 + more, 402)}}, keys).value();
      for (std::size_t i = 0; i < keys.size(); ++i)
        for (const Side side : {Side::left, Side::right})
          EXPECT_TRUE(near(c.motion(keys.times()[i], side).orientation, keys.orientations()[i], tolerance::series));
    }
}

TEST(BetaThrough, IsG1AndTurnsFasterByBeta1AfterAKey) {
  const Parameters betas = mixed_betas(8, 403);
  const Keyframes keys = keyframes(at_whole_times(random_walk(404, 8, Spacing::even)));
  const CubicBezierCurve curve = typed_curve<BetaThrough>(keys, {.parameters = betas});
  for (std::size_t key = 1; key < 7; ++key) {
    const Joint j = joint_of(curve, key);
    EXPECT_LE((j.after1 - betas.at("beta1")[key] * j.before1).norm(), tolerance::series * j.after1.norm());
  }
}

TEST(BetaThrough, IsNotG2AsThePublishedCurveIsNot) {
  const Parameters betas = mixed_betas(8, 405);
  const Keyframes keys = keyframes(at_whole_times(random_walk(406, 8, Spacing::even)));
  const CubicBezierCurve curve = typed_curve<BetaThrough>(keys, {.parameters = betas});
  for (std::size_t key = 1; key < 7; ++key)
    EXPECT_GT(relative_g2_residual(joint_of(curve, key), betas.at("beta1")[key], betas.at("beta2")[key]), 1e-3);
}

TEST(BetaThrough, IsThePublishedCurveOfItsAuxiliaryPoints) {
  const Parameters betas = mixed_betas(9, 407);  // of seven keys and two ghosts
  const Keyframes keys = keyframes(at_whole_times(random_walk(408, 7, Spacing::even)));
  const CubicBezierCurve curve = typed_curve<BetaThrough>(keys, {.parameters = betas});

  // The two points on an arc of length Δ stand γ_i behind its start and β₁² γ_{i+1} before its end.
  const std::vector<Eigen::Quaterniond> q = control_points(curve);
  KeyframeData auxiliary;
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d unit = increment<double>(q[3 * i + 1], q[3 * i + 2]);
    auxiliary.orientations.push_back(q[3 * i + 1] * exp<double>(-gamma_of(betas, i + 1) * unit));
    if (i < 5) continue;
    const double b1 = betas.at("beta1")[i + 2];
    auxiliary.orientations.push_back(q[3 * i + 2] * exp<double>(b1 * b1 * gamma_of(betas, i + 2) * unit));
  }
  auto& p = auxiliary.orientations;
  const Eigen::Quaterniond first = p[0] * p[1].conjugate() * p[0], last = p[6] * p[5].conjugate() * p[6];
  p.insert(p.begin(), first);
  p.push_back(last);
  for (int i = -1; i < 8; ++i) auxiliary.times.push_back(i);
  const AnyCurve published = make_curve({"beta", {.parameters = betas}}, keyframes(auxiliary)).value();

  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(curve.motion(t, curve.knots().segment_at(t)), published.motion(t),
                     {tolerance::series, tolerance::rates, tolerance::rates, tolerance::rates}));
}

TEST(BetaThrough, GhostsHaveTheValuesOfTheirNeighboursUnlessTheyHaveTheirOwn) {
  const Keyframes keys = keyframes(random_walk(409, 4, Spacing::even));
  const auto with = [&](std::vector<double> beta2) {
    return make_curve({"beta-through", {.parameters = {{"beta2", std::move(beta2)}}}}, keys).value();
  };
  const AnyCurve one = with({2.0, 1.0, 0.5, 3.0}), same = with({2.0, 2.0, 1.0, 0.5, 3.0, 3.0});
  const AnyCurve other = with({7.0, 2.0, 1.0, 0.5, 3.0, 3.0});
  const double t = keys.times()[0] + 0.2;
  EXPECT_EQ(one(t).coeffs(), same(t).coeffs());
  EXPECT_GT(angular_distance(one(t), other(t)), 1e-4);
}

TEST(BetaThrough, OnOneAxisIsTheSplineOfTheAngle) {
  KeyframeData data = at_whole_times(random_walk(410, 6, Spacing::even));
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  const std::array angles{0.0, 1.2, 0.7, 2.0, 2.3, 1.1};
  for (std::size_t i = 0; i < 6; ++i) {
    data.orientations[i] = exp<double>(angles[i] * axis);
    data.positions.push_back(angles[i] * axis);
  }
  const PoseCurve pose =
      make_pose_curve({"beta-through", {.parameters = mixed_betas(6, 411)}}, keyframes(data)).value();
  for (const double t : sample_times(data.times))
    EXPECT_TRUE(near(log<double>(pose.orientation(t)), Eigen::Vector3d(pose.position->linear_motion(t).position),
                     tolerance::series));
}

TEST(BetaThrough, PositionsPassThroughTheirKeysFarFromTheOrigin) {
  KeyframeData data = random_walk(412, 7, Spacing::uneven);
  Dice dice(413);
  for (std::size_t i = 0; i < 7; ++i) data.positions.push_back(Eigen::Vector3d(6.4e6, -2e6, 1e5) + dice.vector());
  const PoseCurve pose =
      make_pose_curve({"beta-through", {.parameters = mixed_betas(9, 414)}}, keyframes(data)).value();
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_LE((pose.position->linear_motion(data.times[i]).position - data.positions[i]).norm(),
              1e-8);  // 8 ulp of 6.4e6 m
}

TEST(BetaThrough, RefusesPolesWithTheKeyThatTheyBelongTo) {
  const Keyframes keys = keyframes(random_walk(415, 4, Spacing::even));
  const auto key_of = [&](std::vector<double> beta2) {
    const auto c = make_curve({"beta-through", {.parameters = {{"beta2", std::move(beta2)}}}}, keys);
    EXPECT_EQ(c.error().code, ErrorCode::bad_argument);
    EXPECT_NE(c.error().message.find("more than -2 beta1 (1 + beta1) = -4"), std::string::npos);
    return c.error().where.key.value();
  };
  EXPECT_EQ(key_of({0, 0, -4, 0}), 2u);
  EXPECT_EQ(key_of({0, 0, 0, -4, 0, 0}), 2u);
  EXPECT_EQ(key_of({-4, 0, 0, 0}), 0u);
  EXPECT_EQ(key_of({0, 0, 0, -4}), 3u);
}

TEST(BetaThrough, NamesTheGhostKeyThatAValueBelongsTo) {
  const Keyframes keys = keyframes(random_walk(415, 4, Spacing::even));
  const auto place_of = [&](std::vector<double> beta2) {
    const auto c = make_curve({"beta-through", {.parameters = {{"beta2", std::move(beta2)}}}}, keys);
    const std::string text = describe(c.error());
    return text.substr(0, text.find(": beta-through"));
  };
  for (const double refused : {-4.0, std::numeric_limits<double>::quiet_NaN()}) {  // a pole, and out of range
    EXPECT_EQ(place_of({refused, 0, 0, 0, 0, 0}), "ghost key before key 0");
    EXPECT_EQ(place_of({0, refused, 0, 0, 0, 0}), "key 0");
    EXPECT_EQ(place_of({0, 0, 0, 0, refused, 0}), "key 3");
    EXPECT_EQ(place_of({0, 0, 0, 0, 0, refused}), "ghost key after key 3");
  }
}

TEST(BetaThrough, TellsWhereItsEquationsHaveNoSolution) {
  KeyframeData data = at_whole_times(random_walk(416, 6, Spacing::even));
  for (std::size_t i = 0; i < 6; ++i)
    data.orientations[i] = exp<double>(i % 2 == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(5.5, 0, 0));
  const auto c = make_curve("beta-through", keyframes(data));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::not_converged);
  EXPECT_NE(c.error().message.find("beta-through does not converge for these keys: the residual stays at"),
            std::string::npos);
  EXPECT_LT(c.error().where.key.value(), 6u);
}

}}  // namespace orispline
