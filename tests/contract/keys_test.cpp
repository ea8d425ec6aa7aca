// SPDX-License-Identifier: Apache-2.0
// Contract: a curve is of unit quaternions, runs where it says and touches the keys it says, from one key upwards.
#include <array>

#include <contract/family_contract.hpp>
#include <support/properties.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

class KeyContract : public FamilyContract {};

TEST_P(KeyContract, OrientationIsAUnitQuaternion) {
  EXPECT_TRUE(holds("unit norm", [](const RandomKeys& random) {
    const AnyCurve c = curve(keyframes(fitting(GetParam(), random)));
    for (const double t : times_on(c, 7)) RC_ASSERT(std::abs(c(t).norm() - 1.0) <= tolerance::algebra);
  }));
}

TEST_P(KeyContract, PassesWithItsSignThroughEveryKeyThatItTouches) {
  EXPECT_TRUE(holds("interpolation", [](const RandomKeys& random) {
    const Keyframes keys = keyframes(fitting(GetParam(), random));
    const AnyCurve c = curve(keys);
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (GetParam().passes_through(i))
        for (const Side side : {Side::left, Side::right})
          require(near(c.motion(keys.times()[i], side).orientation, keys.orientations()[i], tolerance::algebra));
  }));
}

TEST_P(KeyContract, MissesEveryOtherKey) {
  const Keyframes keys = keyframes(walk(10, 7, Spacing::uneven));
  const AnyCurve c = curve(keys);
  std::size_t missed = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (GetParam().passes_through(i)) continue;
    ++missed;
    EXPECT_GE(angular_distance(c(keys.times()[i]), keys.orientations()[i]), tolerance::visible_jump) << "key " << i;
  }
  EXPECT_EQ(missed == 0, GetParam().interpolates);
}

TEST_P(KeyContract, MotionAndCallGiveTheSameOrientation) {
  const AnyCurve c = curve(keyframes(walk(11, 6, Spacing::uneven)));
  for (const double t : times_on(c)) EXPECT_TRUE(near(c.motion(t).orientation, c(t), tolerance::exact)) << t;
}

TEST_P(KeyContract, DomainIsFromTheFirstToTheLastKeyOfItsRun) {
  const Keyframes keys = keyframes(walk(12, 4, Spacing::uneven));
  EXPECT_EQ(curve(keys).domain().start, keys.times()[use().first]);
  EXPECT_EQ(curve(keys).domain().end, keys.times()[keys.size() - 1 - use().first]);
}

TEST_P(KeyContract, KnotsAreTheTimesOfTheJoints) {
  const Keyframes keys = keyframes(walk(12, 4, Spacing::uneven));
  const AnyCurve c = curve(keys);
  ASSERT_EQ(c.knots().segments(), 4u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(c.knots().times()[i], keys.times()[use().first + i * use().stride]) << "joint " << i;
}

TEST_P(KeyContract, OneKeyIsAConstantCurve) {
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(1, 2, 3));
  const AnyCurve c = curve(keyframes({.times = {5.0}, .orientations = {q}}));
  for (const double t : {-1.0, 5.0, 9.0}) {
    EXPECT_TRUE(near(c.motion(t).orientation, q, tolerance::exact));
    EXPECT_EQ(c.motion(t).angular_velocity, Eigen::Vector3d::Zero());
    EXPECT_EQ(c.motion(t).angular_acceleration, Eigen::Vector3d::Zero());
  }
}

TEST_P(KeyContract, NoKeysAreAnErrorThatSaysSo) {
  for (const CurveOptions& options : {CurveOptions{}, CurveOptions{.loop = Loop{}}, CurveOptions{.loop = Loop{1.0}}}) {
    const auto c = make_pose_curve({GetParam().name, options}, Keyframes());
    ASSERT_FALSE(c);
    EXPECT_EQ(c.error().code, ErrorCode::bad_data);
    EXPECT_TRUE(c.error().message.ends_with("found 0")) << c.error().message;
  }
}

TEST_P(KeyContract, FewerKeysThanItNeedsAreAnErrorThatSaysSo) {
  for (int n = 2; n < GetParam().min_keys; ++n) {
    const auto c = make_curve(GetParam().name, keyframes(random_walk(13, static_cast<std::size_t>(n), Spacing::even)));
    ASSERT_FALSE(c) << n;
    EXPECT_EQ(c.error().code, ErrorCode::bad_data);
    EXPECT_NE(c.error().message.find(std::to_string(GetParam().min_keys)), std::string::npos);
  }
  EXPECT_EQ(use().keys_for(1), static_cast<std::size_t>(GetParam().min_keys));
}

TEST_P(KeyContract, TakesExactlyTheKeyCountsThatItDeclares) {
  for (auto n = static_cast<std::size_t>(GetParam().min_keys); n <= 12; ++n) {
    const auto c = make_curve(GetParam().name, keyframes(random_walk(13, n, Spacing::even)));
    EXPECT_EQ(c.has_value(), use().cut(n) == n) << n << " keys";
    if (c) {
      EXPECT_EQ(use().keys_for(c->knots().segments()), n);
    }
  }
}

TEST_P(KeyContract, FewestKeysWorkWithEveryEndRule) {
  for (const EndRule rule : GetParam().ends) {
    const auto needed = static_cast<std::size_t>(rule == EndRule::cubic ? 4 : rule == EndRule::quadratic ? 3 : 2);
    const Keyframes keys = keyframes(random_walk(14, needed, Spacing::uneven));
    const AnyCurve c = curve(keys, {.start = {.rule = rule}, .end = {.rule = rule}});
    for (std::size_t i = 0; i < keys.size(); ++i)
      EXPECT_TRUE(near(c(keys.times()[i]), keys.orientations()[i], tolerance::algebra)) << name_of(rule);
  }
}

TEST_P(KeyContract, PassesThroughItsKeysOnStepsFromMicrosecondsToDaysWithEveryEndRule) {
  if (GetParam().ends.empty()) return;
  const std::array<std::array<double, 5>, 2> spacings{{{1e-6, 1e6, 1e-6, 1e6, 1.0}, {1e6, 1e-6, 1.0, 1e-6, 1e6}}};
  for (const auto& steps : spacings) {
    KeyframeData data = random_walk(16, steps.size() + 1, Spacing::even, 1.0);
    for (std::size_t i = 0; i < steps.size(); ++i) data.times[i + 1] = data.times[i] + steps[i];
    const Keyframes keys = keyframes(data);
    for (const EndRule start : GetParam().ends)
      for (const EndRule end : GetParam().ends) {
        const auto made = make_curve({GetParam().name, {.start = {.rule = start}, .end = {.rule = end}}}, keys);
        if (!made) continue;  // a method that refuses such steps says so
        for (std::size_t i = 0; i < keys.size(); ++i) {
          if (!GetParam().passes_through(i)) continue;
          for (const Side side : {Side::left, Side::right})
            EXPECT_LE(angular_distance(made->motion(keys.times()[i], side).orientation, keys.orientations()[i]),
                      tolerance::algebra)
                << name_of(start) << ", " << name_of(end) << ", key " << i;
        }
      }
  }
}

TEST_P(KeyContract, FewestKeysOnAGreatArcGiveACurveOnIt) {
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  KeyframeData data = walk(15, 1, Spacing::even);
  for (std::size_t i = 0; i < data.times.size(); ++i)
    data.orientations[i] = data.orientations[0] * exp<double>(std::array{0.0, 1.1, 0.7, 1.9}.at(i) * axis);
  const AnyCurve c = curve(keyframes(data));
  for (const double t : times_on(c, 8)) {
    const Eigen::Vector3d off_arc = increment<double>(data.orientations[0], c(t)).cross(axis);
    EXPECT_LE(off_arc.norm(), tolerance::algebra) << t;
  }
  EXPECT_GT(angular_distance(c(c.domain().start), c(c.domain().end)), 0.1);
}

ORISPLINE_FOR_EVERY_FAMILY(KeyContract);

}}  // namespace orispline::contract
