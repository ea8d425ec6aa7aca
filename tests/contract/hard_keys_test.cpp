// SPDX-License-Identifier: Apache-2.0
// Contract: keys that are hard to interpolate still give finite motions through the keys that the curve touches. The
// solved families that declare it may answer instead that their equations were not solved, and where.
#include <contract/family_contract.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

enum class Refusal { not_allowed, allowed };

class HardKeyContract : public FamilyContract {
 protected:
  [[nodiscard]] static Refusal turns_are_too_wide() {
    return testing_support::may_refuse(GetParam()) ? Refusal::allowed : Refusal::not_allowed;
  }
  /// A curve that turned by radians within microseconds goes on turning for thousands of rounds where it is solved, and
  /// for millions where its rates are those of a polynomial.
  [[nodiscard]] static Refusal times_are_too_uneven() {
    return GetParam().is_global() || GetParam().rate_orders > 0 ? Refusal::allowed : Refusal::not_allowed;
  }

  static void expect_finite_motion_through(const Keyframes& keys, Refusal refusal = turns_are_too_wide()) {
    const auto made = make_curve(GetParam().name, keys);
    if (!made && refusal == Refusal::allowed) return expect_honest_refusal(made.error(), keys);
    ASSERT_TRUE(made) << describe(made.error());
    const AnyCurve& c = *made;
    for (const double t : times_on(c, 16)) {
      const Motion m = c.motion(t);
      EXPECT_NEAR(m.orientation.norm(), 1.0, tolerance::algebra) << t;
      EXPECT_TRUE(m.angular_velocity.allFinite() && m.angular_acceleration.allFinite() && m.angular_jerk.allFinite())
          << t;
    }
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (GetParam().passes_through(i)) {
        EXPECT_TRUE(near(c(keys.times()[i]), keys.orientations()[i], tolerance::series)) << "key " << i;
      }
  }

  static void expect_honest_refusal(const Error& error, const Keyframes& keys) {
    if (is_wound_too_far(GetParam(), error)) return;
    EXPECT_EQ(error.code, ErrorCode::not_converged);
    ASSERT_TRUE(error.where.key.has_value());
    EXPECT_LT(*error.where.key, keys.size());
    EXPECT_TRUE(error.message.starts_with(std::string(GetParam().name) + " does not converge for these keys: "))
        << error.message;
    EXPECT_TRUE(error.message.find("residual stays at ") != std::string::npos ||
                error.message.find("the average jumps by ") != std::string::npos ||
                error.message.find("its equations hold only for a curve that winds round") != std::string::npos)
        << error.message;
  }

  /// Four keys with steps of `angle` [rad] about changing axes.
  [[nodiscard]] static KeyframeData steps_of(double angle) {
    KeyframeData data{.times = {0.0, 1.0, 1.5, 3.0}};
    Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.2, 0.1, -0.4));
    for (std::size_t i = 0; i < 4; ++i) {
      data.orientations.push_back(q);
      q = q * exp<double>(angle * specimen_axes()[i]);
    }
    return data;
  }
};

TEST_P(HardKeyContract, StepsNearHalfATurn) {
  for (const double angle : {pi - 1e-3, pi - 1e-6, pi - 1e-9, pi - 1e-12})
    expect_finite_motion_through(keyframes(steps_of(angle), Signs::shortest));
}

TEST_P(HardKeyContract, StepsOfExactlyHalfATurn) {
  const KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0},
                          .orientations = {quaternion_wxyz(1.0, 0.0, 0.0, 0.0), quaternion_wxyz(0.0, 1.0, 0.0, 0.0),
                                           quaternion_wxyz(0.0, 0.0, 1.0, 0.0), quaternion_wxyz(0.0, 0.0, 0.0, 1.0)}};
  expect_finite_motion_through(keyframes(data, Signs::shortest), Refusal::not_allowed);
}

TEST_P(HardKeyContract, StepsBeyondHalfATurnWithSignsAsGiven) {
  for (const double angle : {pi + 1e-9, 3.5, 5.0}) expect_finite_motion_through(keyframes(steps_of(angle)));
}

TEST_P(HardKeyContract, WideTurnsAtUnevenTimes) {
  for (const std::uint64_t seed : {101u, 102u, 103u, 104u, 105u, 106u})
    expect_finite_motion_through(keyframes(random_walk(seed, use().keys_for(8), Spacing::uneven, 1.5)));
}

TEST_P(HardKeyContract, RepeatedKeys) {
  const Eigen::Quaterniond p = exp<double>(Eigen::Vector3d(0.5, 0.2, 0.1)), q = exp<double>(Eigen::Vector3d(-1, 1, 2));
  expect_finite_motion_through(
      keyframes({.times = {0.0, 1.0, 1.5, 3.0, 3.5, 4.5, 5.0}, .orientations = {p, p, q, q, q, p, p}}));
}

TEST_P(HardKeyContract, TinySteps) {
  for (const double angle : {1e-8, 1e-12, 1e-16, 1e-100})
    expect_finite_motion_through(keyframes(steps_of(angle), Signs::shortest), Refusal::not_allowed);
}

TEST_P(HardKeyContract, SpacingFromMicrosecondsToHours) {
  KeyframeData data = steps_of(0.8);
  data.times = {0.0, 1e-6, 1.0, 3600.0};
  expect_finite_motion_through(keyframes(data), times_are_too_uneven());
}

ORISPLINE_FOR_EVERY_FAMILY(HardKeyContract);

}}  // namespace orispline::contract
