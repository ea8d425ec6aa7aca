// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, the Beta quaternion spline: what is true of it in general and what is not.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/beta_joints.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::Beta;

TEST(Beta, TurnsFasterByBeta1AfterAJoint) {
  // Equation 8: s'_i(0) = β_{i,1} s'_{i-1}(1), whatever β₂.
  const Keyframes keys = keyframes(random_walk(371, 8, Spacing::even));
  const Parameters betas = mixed_betas(8, 372);
  const CubicBezierCurve curve = beta(keys, betas);
  for (std::size_t joint = 1; joint < curve.knots().segments(); ++joint) {
    const Joint j = joint_of(curve, joint);
    EXPECT_LE((j.after1 - betas.at("beta1")[joint + 1] * j.before1).norm(), tolerance::series * j.after1.norm());
  }
}

TEST(Beta, IsC1ForBeta1OfOneWhateverBeta2) {
  const Keyframes keys = keyframes(random_walk(373, 8, Spacing::even));
  const CubicBezierCurve curve = beta(keys, {{"beta2", mixed_betas(8, 374).at("beta2")}});
  for (std::size_t joint = 1; joint < curve.knots().segments(); ++joint) {
    const Joint j = joint_of(curve, joint);
    EXPECT_LE((j.after1 - j.before1).norm(), tolerance::series * j.after1.norm());
  }
}

TEST(Beta, IsG2WhereTheKeysTurnAboutOneAxis) {
  KeyframeData data = random_walk(375, 7, Spacing::even);
  const std::array angles{0.0, 0.5, 0.3, 1.4, 2.0, 1.7, 2.4};
  data.times = {0, 1, 2, 3, 4, 5, 6};
  for (std::size_t i = 0; i < 7; ++i) data.orientations[i] = exp<double>(Eigen::Vector3d(0, angles[i], 0));
  const Parameters betas = mixed_betas(7, 376);
  const CubicBezierCurve curve = beta(keyframes(data), betas);
  for (std::size_t joint = 1; joint < curve.knots().segments(); ++joint) {
    // About one axis s = (cos, sin) of half the angle: the constraint holds for the angle, seen here as ω and α.
    const double t = curve.knots().times()[joint];
    const Motion before = curve.motion(t, joint - 1), after = curve.motion(t, joint);
    const double beta1 = betas.at("beta1")[joint + 1], beta2 = betas.at("beta2")[joint + 1];
    EXPECT_TRUE(near(after.angular_acceleration,
                     beta1 * beta1 * before.angular_acceleration + beta2 * before.angular_velocity, tolerance::series));
  }
}

TEST(Beta, IsG2InSpaceAsBarskySays) {
  KeyframeData data = random_walk(377, 8, Spacing::even);
  Dice dice(378);
  for (std::size_t i = 0; i < 8; ++i) {
    data.times[i] = static_cast<double>(i);
    data.positions.push_back(3.0 * dice.vector());
  }
  const Parameters betas = mixed_betas(8, 379);
  const auto path = typed_path<Beta>(keyframes(data), {.parameters = betas});
  for (std::size_t joint = 1; joint < path.knots().segments(); ++joint) {
    const double t = path.knots().times()[joint];
    const double beta1 = betas.at("beta1")[joint + 1], beta2 = betas.at("beta2")[joint + 1];
    const auto before = path.point(Jet<double, 2>::variable(t), joint - 1);
    const auto after = path.point(Jet<double, 2>::variable(t), joint);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(after[axis].derivative(0), before[axis].derivative(0), tolerance::algebra);
      EXPECT_NEAR(after[axis].derivative(1), beta1 * before[axis].derivative(1), tolerance::series);
      EXPECT_NEAR(after[axis].derivative(2),
                  beta1 * beta1 * before[axis].derivative(2) + beta2 * before[axis].derivative(1), tolerance::series);
    }
  }
}

TEST(Beta, AtItsDefaultsIsTheCubicBSplineInSpaceButNotOnTheSphere) {
  KeyframeData data = random_walk(380, 8, Spacing::even);
  Dice dice(381);
  for (std::size_t i = 0; i < 8; ++i) data.positions.push_back(3.0 * dice.vector());
  const Keyframes keys = keyframes(data);
  const PoseCurve found = make_pose_curve("beta", keys).value(), bspline = make_pose_curve("bspline", keys).value();
  double largest = 0.0;
  for (const double t : sample_times(found.orientation.knots().times())) {
    EXPECT_TRUE(near(found.position->linear_motion(t).position, bspline.position->linear_motion(t).position,
                     tolerance::algebra));
    largest = std::max(largest, angular_distance(found.orientation(t), bspline.orientation(t)));
  }
  EXPECT_GT(largest, tolerance::visible_jump);
}

TEST(Beta, ControlPointsDivideTheirArcsAsStated) {
  // β = (1, 0.5): γ = 8/9, Δ = 25/9, so the inner points stand at 0.32 and 0.68 of the way.
  const Keyframes keys = keyframes(random_walk(382, 5, Spacing::even));
  const auto points = control_points(beta(keys, beta_of_the_examples));
  const auto on_arc = [&](std::size_t i, double s) {
    const Eigen::Vector3d arc = increment<double>(keys.orientations()[i], keys.orientations()[i + 1]);
    return Eigen::Quaterniond(keys.orientations()[i] * exp<double>(s * arc));
  };
  EXPECT_TRUE(near(points[1], on_arc(1, 0.32), tolerance::algebra));
  EXPECT_TRUE(near(points[2], on_arc(1, 0.68), tolerance::algebra));
  const Eigen::Quaterniond middle =
      on_arc(0, 0.68) * exp<double>(0.5 * increment<double>(on_arc(0, 0.68), on_arc(1, 0.32)));
  EXPECT_TRUE(near(points[0], middle, tolerance::algebra));
}

TEST(Beta, LargeBeta2DrawsTheJointsToTheirControlPoints) {
  const Keyframes keys = keyframes(random_walk(383, 6, Spacing::even));
  const AnyCurve c = make_curve({"beta", {.parameters = {{"beta2", {1e6}}}}}, keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i)
    EXPECT_LT(angular_distance(c(keys.times()[i]), keys.orientations()[i]), 1e-4) << i;
}

TEST(Beta, ChangeOfBeta2TouchesFourSegments) {
  const Keyframes keys = keyframes(random_walk(384, 11, Spacing::even));
  std::vector<double> beta2(11, 0.5);
  const CubicBezierCurve before = beta(keys, {{"beta2", beta2}});
  beta2[5] = 3.0;
  const CubicBezierCurve after = beta(keys, {{"beta2", beta2}});
  for (std::size_t segment = 0; segment < before.knots().segments(); ++segment) {
    const double t = before.knots().span(segment).start() + 0.4;
    const bool changed =
        before.motion(t, segment).orientation.coeffs() != after.motion(t, segment).orientation.coeffs();
    EXPECT_EQ(changed, 2 <= segment && segment <= 5) << "segment " << segment;
  }
}

TEST(Beta, RefusesPolesAndFoldedRangesWithTheKey) {
  const Keyframes keys = keyframes(random_walk(385, 5, Spacing::even));
  const auto message = [&](std::vector<double> beta1, std::vector<double> beta2) {
    const auto c = make_curve({"beta", {.parameters = {{"beta1", beta1}, {"beta2", beta2}}}}, keys);
    EXPECT_TRUE(c || c.error().code == ErrorCode::bad_argument);
    return c ? std::string() : describe(c.error());
  };
  const std::string reason = ": there the control points of the construction meet a pole or fold back";
  EXPECT_EQ(message({1}, {0, 0, -4, 0, 0}),
            "key 2: beta: beta2 is -4, wanted more than -2 beta1 (1 + beta1) = -4" + reason);
  EXPECT_EQ(message({1, 1, 1, 2, 1}, {0, 0, 0, -12.5, 0}),
            "key 3: beta: beta2 is -12.5, wanted more than -2 beta1 (1 + beta1) = -12" + reason);
  EXPECT_EQ(message({1}, {0, -12, 0, 0, 0}),
            "key 1: beta: beta2 is -12, wanted more than -2 beta1 (1 + beta1) = -4" + reason);
  EXPECT_EQ(message({1}, {-3.9}), "");
  EXPECT_EQ(message({1, 1, 1, 2, 1}, {0, 0, 0, -11.9, 0}), "");
  EXPECT_EQ(message({0}, {0}), "beta: beta1 is 0, wanted 1e-06 to 1000000");
}

TEST(Beta, RefusesThePoleForPositionsToo) {
  KeyframeData data = random_walk(386, 5, Spacing::even);
  data.positions.assign(5, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(make_pose_curve({"beta", {.parameters = {{"beta2", {-4.0}}}}}, keyframes(data)));
}

TEST(Beta, StaysFiniteOverItsWholeRange) {
  const Keyframes keys = keyframes(random_walk(387, 6, Spacing::even));
  for (const double beta1 : {1e-6, 1.0, 1e6})
    for (const double beta2 : {0.0, 1e6}) {
      const AnyCurve c = make_curve({"beta", {.parameters = {{"beta1", {beta1}}, {"beta2", {beta2}}}}}, keys).value();
      for (const double t : sample_times(c.knots().times())) {
        const Motion m = c.motion(t);
        EXPECT_NEAR(m.orientation.norm(), 1.0, tolerance::algebra);
        EXPECT_TRUE(m.angular_jerk.allFinite());
      }
    }
}

}}  // namespace orispline
