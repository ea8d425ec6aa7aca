// SPDX-License-Identifier: Apache-2.0
// Kochanek and Bartels: what tension, continuity and bias do to the rates at a key, and how the ends go.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

const End handle{.rule = EndRule::handle};

Keyframes posed_keys(std::uint64_t seed, std::size_t count = 6) {
  KeyframeData data = random_walk(seed, count, Spacing::uneven, 0.8);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < count; ++i) data.positions.push_back(3.0 * dice.vector());
  return keyframes(data);
}

/// One value per key of each parameter.
CurveOptions random_options(std::uint64_t seed, std::size_t keys) {
  CurveOptions options;
  Dice dice(seed);
  for (const char* name : {"tension", "continuity", "bias"})
    for (std::size_t i = 0; i < keys; ++i) options.parameters[name].push_back(dice.between(-0.6, 0.6));
  return options;
}

/// The rates on either side of a key, (8) and (9) of the paper with its times.
struct Rates {
  Eigen::Vector3d arriving, leaving;
};

Rates published_rates(const Eigen::Vector3d& step_before, const Eigen::Vector3d& step_after, double before,
                      double after, double tension, double continuity, double bias) {
  const Eigen::Vector3d slow = after / (before + after) * step_before / before;
  const Eigen::Vector3d fast = before / (before + after) * step_after / after;
  const double t = 1.0 - tension, c = continuity, b = bias;
  return {.arriving = t * (1.0 - c) * (1.0 + b) * slow + t * (1.0 + c) * (1.0 - b) * fast,
          .leaving = t * (1.0 + c) * (1.0 + b) * slow + t * (1.0 - c) * (1.0 - b) * fast};
}

TEST(Tcb, PassesInnerKeysWithTheRatesOfKochanekAndBartels) {
  const Keyframes keys = posed_keys(411);
  const CurveOptions options = random_options(412, keys.size());
  const PoseCurve pose = make_pose_curve({"tcb", options}, keys).value();
  const auto q = keys.orientations();
  const auto p = keys.positions();
  const auto t = keys.times();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const auto rates = [&](const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
      const auto value = [&](const char* name) { return options.parameters.at(name)[i]; };
      return published_rates(before, after, t[i] - t[i - 1], t[i + 1] - t[i], value("tension"), value("continuity"),
                             value("bias"));
    };
    const Rates turning = rates(increment<double>(q[i - 1], q[i]), increment<double>(q[i], q[i + 1]));
    EXPECT_TRUE(near(pose.orientation.motion(t[i], Side::left).angular_velocity, turning.arriving, tolerance::rates));
    EXPECT_TRUE(near(pose.orientation.motion(t[i], Side::right).angular_velocity, turning.leaving, tolerance::rates));
    const Rates moving = rates(p[i] - p[i - 1], p[i + 1] - p[i]);
    EXPECT_TRUE(near(pose.position->linear_motion(t[i], Side::left).velocity, moving.arriving, tolerance::rates));
    EXPECT_TRUE(near(pose.position->linear_motion(t[i], Side::right).velocity, moving.leaving, tolerance::rates));
  }
}

TEST(Tcb, NaturalEndStartsWithTheRateOfTheFirstStepAndTheTensionOfItsKey) {
  const Keyframes keys = posed_keys(413);
  const Eigen::Vector3d secant =
      increment<double>(keys.orientations()[0], keys.orientations()[1]) / (keys.times()[1] - keys.times()[0]);
  const AnyCurve plain = make_curve("tcb", keys).value();
  EXPECT_TRUE(near(plain.motion(keys.times()[0]).angular_velocity, secant, tolerance::series));
  const AnyCurve tense = make_curve({"tcb", {.parameters = {{"tension", {0.4}}}}}, keys).value();
  EXPECT_TRUE(near(tense.motion(keys.times()[0]).angular_velocity, 0.6 * secant, tolerance::series));
}

TEST(Tcb, TensionOneStopsAtEveryKey) {
  const Keyframes keys = posed_keys(414);
  const AnyCurve curve = make_curve({"tcb", {.parameters = {{"tension", {1}}}}}, keys).value();
  for (const double t : keys.times())
    for (const Side side : {Side::left, Side::right})
      EXPECT_LE(curve.motion(t, side).angular_velocity.norm(), tolerance::series);
}

TEST(Tcb, ContinuityOtherThanZeroMakesACornerInTime) {
  const Keyframes keys = posed_keys(415);
  const AnyCurve curve = make_curve({"tcb", {.parameters = {{"continuity", {0.4}}}}}, keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double t = keys.times()[i];
    EXPECT_GT((curve.motion(t, Side::left).angular_velocity - curve.motion(t, Side::right).angular_velocity).norm(),
              0.01);
  }
}

TEST(Tcb, HandleEndsHaveNoAcceleration) {
  const Keyframes keys = posed_keys(416);
  CurveOptions options = random_options(417, keys.size());
  options.start = options.end = handle;
  const PoseCurve pose = make_pose_curve({"tcb", options}, keys).value();
  for (const double t : {keys.times().front(), keys.times().back()}) {
    EXPECT_LE(pose.orientation.motion(t).angular_acceleration.norm(), tolerance::rates);
    EXPECT_LE(pose.position->linear_motion(t).acceleration.norm(), tolerance::rates);
  }
}

TEST(Tcb, ParametersOfAKeyWithAHandleEndDoNotMatter) {
  const Keyframes keys = posed_keys(418);
  CurveOptions options = random_options(419, keys.size());
  options.start = options.end = handle;
  const AnyCurve before = make_curve({"tcb", options}, keys).value();
  for (auto& [name, values] : options.parameters) values.front() = values.back() = 0.9;
  const AnyCurve after = make_curve({"tcb", options}, keys).value();
  for (const double t : sample_times(keys.times())) EXPECT_EQ(after(t).coeffs(), before(t).coeffs());
}

TEST(Tcb, TwoKeysWithHandleEndsTurnAtAConstantRate) {
  const Keyframes keys = posed_keys(420, 2);
  const Eigen::Vector3d secant =
      increment<double>(keys.orientations()[0], keys.orientations()[1]) / (keys.times()[1] - keys.times()[0]);
  const AnyCurve curve =
      make_curve({"tcb", {.parameters = {{"tension", {0.7}}}, .start = handle, .end = handle}}, keys).value();
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(curve.motion(t).angular_velocity, secant, tolerance::series));
}

TEST(Tcb, OneHandleEndOfTwoKeysLeavesTheOtherEndAlone) {
  const Keyframes keys = posed_keys(421, 2);
  const CurveOptions tense{.parameters = {{"tension", {0.7}}}};
  const AnyCurve natural = make_curve({"tcb", tense}, keys).value();
  const double start = keys.times().front(), end = keys.times().back();
  for (const auto& [end_of_rule, at, other] :
       {std::tuple{&CurveOptions::start, start, end}, std::tuple{&CurveOptions::end, end, start}}) {
    CurveOptions one_handle = tense;
    one_handle.*end_of_rule = handle;
    const AnyCurve curve = make_curve({"tcb", one_handle}, keys).value();
    EXPECT_TRUE(near(curve.motion(other).angular_velocity, natural.motion(other).angular_velocity, tolerance::series));
    EXPECT_LE(curve.motion(at).angular_acceleration.norm(), tolerance::rates);
    EXPECT_GT((curve.motion(at).angular_velocity - natural.motion(at).angular_velocity).norm(), 0.01);
  }
}

TEST(Tcb, LosesC1WhereAHandleIsLongerThanAFullTurn) {
  // Known limit of the method: key 1 turns at 22.7 rad/s, a third of which is the handle of the slow segment before it,
  // and de Casteljau's algorithm takes its logarithm.
  KeyframeData data{.times = {0.0, 1.0, 1.1, 2.1}};
  for (const double angle : {0.0, 0.0, 2.5, 2.5})
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  const AnyCurve curve = make_curve("tcb", keyframes(data)).value();
  const Motion left = curve.motion(1.0, Side::left), right = curve.motion(1.0, Side::right);
  EXPECT_NEAR(right.angular_velocity.z(), 250.0 / 11.0, tolerance::series);
  EXPECT_GT((left.angular_velocity - right.angular_velocity).norm(), 1.0);
}

}}  // namespace orispline
