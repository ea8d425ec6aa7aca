// SPDX-License-Identifier: Apache-2.0
// Contract: a curve passes through its keys as a unit quaternion, from one key upwards.
#include <contract/family_contract.hpp>
#include <support/properties.hpp>

namespace orispline::contract {
namespace {

using namespace testing_support;

class KeyContract : public FamilyContract {};

TEST_P(KeyContract, OrientationIsAUnitQuaternion) {
  EXPECT_TRUE(holds("unit norm", [](const RandomKeys& random) {
    const Keyframes keys = keyframes(random.data);
    const AnyCurve c = curve(keys);
    for (const double t : sample_times(keys.times(), 7)) RC_ASSERT(std::abs(c(t).norm() - 1.0) <= tolerance::algebra);
  }));
}

TEST_P(KeyContract, PassesThroughEveryKeyWithItsSign) {
  if (!GetParam().interpolates) GTEST_SKIP() << "declared not to interpolate";
  EXPECT_TRUE(holds("interpolation", [](const RandomKeys& random) {
    const Keyframes keys = keyframes(random.data);
    const AnyCurve c = curve(keys);
    for (std::size_t i = 0; i < keys.size(); ++i)
      for (const Side side : {Side::left, Side::right})
        require(near(c.motion(keys.times()[i], side).orientation, keys.orientations()[i], tolerance::algebra));
  }));
}

TEST_P(KeyContract, MotionAndCallGiveTheSameOrientation) {
  const Keyframes keys = keyframes(random_walk(11, 7, Spacing::uneven));
  const AnyCurve c = curve(keys);
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(c.motion(t).orientation, c(t), tolerance::exact)) << t;
}

TEST_P(KeyContract, DomainIsFromTheFirstToTheLastKey) {
  const Keyframes keys = keyframes(random_walk(12, 5, Spacing::uneven));
  EXPECT_EQ(curve(keys).domain().start, keys.times().front());
  EXPECT_EQ(curve(keys).domain().end, keys.times().back());
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

TEST_P(KeyContract, FewerKeysThanItNeedsAreAnErrorThatSaysSo) {
  for (int n = 2; n < GetParam().min_keys; ++n) {
    const auto c = make_curve(GetParam().name, keyframes(random_walk(13, static_cast<std::size_t>(n), Spacing::even)));
    ASSERT_FALSE(c) << n;
    EXPECT_EQ(c.error().code, ErrorCode::bad_data);
    EXPECT_NE(c.error().message.find(std::to_string(GetParam().min_keys)), std::string::npos);
  }
  EXPECT_TRUE(make_curve(GetParam().name,
                         keyframes(random_walk(13, static_cast<std::size_t>(GetParam().min_keys), Spacing::even))));
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

TEST_P(KeyContract, TwoKeysAreJoinedByTheirGreatArc) {
  const Keyframes keys = keyframes(random_walk(15, 2, Spacing::even));
  const Eigen::Vector3d axis = increment<double>(keys.orientations()[0], keys.orientations()[1]).normalized();
  const AnyCurve c = curve(keys);
  for (const double t : sample_times(keys.times(), 8)) {
    const Eigen::Vector3d off_arc = increment<double>(keys.orientations()[0], c(t)).cross(axis);
    EXPECT_LE(off_arc.norm(), tolerance::algebra) << t;
  }
}

ORISPLINE_FOR_EVERY_FAMILY(KeyContract);

}  // namespace
}  // namespace orispline::contract
