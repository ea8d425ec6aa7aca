// SPDX-License-Identifier: Apache-2.0
// AnyCurve: a value that may be copied, asked outside its domain, on either side of a key.
#include <limits>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/families/slerp.hpp>
#include <support/near.hpp>
#include <support/not_finite.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

static_assert(std::is_nothrow_copy_constructible_v<AnyCurve>);
static_assert(noexcept(std::declval<const AnyCurve&>()(0.0)));
static_assert(noexcept(std::declval<const AnyCurve&>().motion(0.0)));
static_assert(noexcept(std::declval<const AnyCurve&>().domain()));

Keyframes five_keys() { return keyframes(random_walk(201, 5, Spacing::uneven)); }
AnyCurve some_curve() { return make_curve("timed-c2", five_keys()).value(); }

TEST(AnyCurve, HoldsTheEndOrientationAtRestOutsideItsDomain) {
  const Keyframes keys = five_keys();
  const AnyCurve curve = some_curve();
  for (const auto& [t, end] : {std::pair{-1e9, 0u}, std::pair{keys.times()[0] - 1e-9, 0u},
                               std::pair{keys.times()[4] + 1e-9, 4u}, std::pair{1e300, 4u}}) {
    EXPECT_TRUE(near(curve(t), keys.orientations()[end], tolerance::algebra)) << t;
    EXPECT_TRUE(near(curve.motion(t), {.orientation = keys.orientations()[end]}, {tolerance::algebra, 0, 0, 0})) << t;
  }
  EXPECT_TRUE(near(curve(-std::numeric_limits<double>::infinity()), keys.orientations()[0], tolerance::algebra));
}

TEST(AnyCurve, KeepsItsRatesAtTheEndsThemselves) {
  const Keyframes keys = five_keys();
  const AnyCurve curve = some_curve();
  for (const double t : {keys.times().front(), keys.times().back()})
    for (const Side side : {Side::left, Side::right}) EXPECT_GT(curve.motion(t, side).angular_velocity.norm(), 0.1);
}

TEST(AnyCurve, RefusesTimesOutsideItsDomainOnRequest) {
  const AnyCurve curve =
      make_curve("slerp",
                 keyframes({.times = {0.0, 2.5},
                            .orientations = {Eigen::Quaterniond::Identity(), exp<double>(Eigen::Vector3d(1, 0, 0))}}))
          .value();
  const auto outside = curve.checked_motion(3.0);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(outside.error().message, "time 3 is outside the curve, wanted 0 to 2.5");
  EXPECT_FALSE(curve.checked_motion(-0.001));
  EXPECT_FALSE(curve.checked_motion(std::numeric_limits<double>::quiet_NaN()));
  for (const double t : {0.0, 1.2, 2.5}) {
    ASSERT_TRUE(curve.checked_motion(t)) << t;
    EXPECT_TRUE(near(curve.checked_motion(t).value(), curve.motion(t), {0, 0, 0, 0}));
  }
}

TEST(AnyCurve, TakesTheSegmentOnTheSideThatIsAskedFor) {
  const Keyframes keys = five_keys();
  const AnyCurve curve = make_curve("slerp", keys).value();
  const auto rate_of_segment = [&](std::size_t i) -> Eigen::Vector3d {
    return increment<double>(keys.orientations()[i], keys.orientations()[i + 1]) /
           (keys.times()[i + 1] - keys.times()[i]);
  };
  for (std::size_t i = 1; i < 4; ++i) {
    const double t = keys.times()[i];
    EXPECT_TRUE(near(curve.motion(t).angular_velocity, rate_of_segment(i), tolerance::series));
    EXPECT_TRUE(near(curve.motion(t, Side::left).angular_velocity, rate_of_segment(i - 1), tolerance::series));
  }
  EXPECT_TRUE(near(curve.motion(keys.times()[4]).angular_velocity, rate_of_segment(3), tolerance::series));
  EXPECT_TRUE(near(curve.motion(keys.times()[0], Side::left).angular_velocity, rate_of_segment(0), tolerance::series));
}

TEST(AnyCurve, AnswersNotANumberToNotANumber) {
  const Keyframes keys = keyframes(random_walk(202, 7, Spacing::uneven, 0.8));
  for (const FamilyInfo& family : families_info()) {
    const AnyCurve curve = make_curve(family.name, keys).value();
    EXPECT_TRUE(curve(nan).coeffs().hasNaN()) << family.name;
    EXPECT_TRUE(curve.motion(nan).orientation.coeffs().hasNaN()) << family.name;
  }
}

TEST(AnyCurve, ThroughOneKeyAnswersNotANumberToNotANumber) {
  KeyframeData data = random_walk(203, 1, Spacing::even);
  data.positions.emplace_back(1, 0, -2);
  const PoseCurve pose = make_pose_curve("auto", keyframes(data)).value();
  for (const Side side : {Side::left, Side::right}) {
    const Motion m = pose.orientation.motion(nan, side);
    EXPECT_TRUE(m.orientation.coeffs().array().isNaN().all());
    EXPECT_TRUE(m.angular_velocity.array().isNaN().all());
    EXPECT_TRUE(pose.position->linear_motion(nan, side).position.array().isNaN().all());
  }
  EXPECT_TRUE(pose.orientation(nan).coeffs().array().isNaN().all());
  EXPECT_FALSE(pose.orientation.checked_motion(nan));
}

TEST(AnyCurve, StaysTheCurveThatItWasWhenItIsMovedFrom) {
  AnyCurve curve = some_curve();
  const AnyCurve moved = std::move(curve);
  EXPECT_EQ(curve.domain().end, moved.domain().end);    // NOLINT: that is what is tested
  EXPECT_EQ(curve(0.3).coeffs(), moved(0.3).coeffs());  // NOLINT
  AnyCurve assigned = make_curve("slerp", five_keys()).value();
  assigned = std::move(curve);
  EXPECT_EQ(curve(0.3).coeffs(), assigned(0.3).coeffs());  // NOLINT
}

TEST(AnyCurve, IsAValue) {
  const AnyCurve curve = some_curve();
  AnyCurve copy = curve;
  const AnyCurve other = make_curve("slerp", five_keys()).value();
  const double t = 0.5 * (curve.domain().start + curve.domain().end);
  EXPECT_EQ(copy(t).coeffs(), curve(t).coeffs());
  copy = other;
  EXPECT_EQ(copy(t).coeffs(), other(t).coeffs());
  EXPECT_NE(copy(t).coeffs(), curve(t).coeffs());
}

/// A curve that no family makes: an accelerating spin.
struct Spinning {
  Knots spinning_knots{{0.0, 10.0}};
  [[nodiscard]] const Knots& knots() const noexcept { return spinning_knots; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t) const noexcept {
    return exp<T>(constant<T>(Eigen::Vector3d(0, 0, 0.5)) * (t * t));
  }
};

TEST(AnyCurve, WrapsACurveOfOnesOwn) {
  const Motion m = AnyCurve(Spinning{}).motion(2.0);
  EXPECT_TRUE(near(m.angular_velocity, Eigen::Vector3d(0, 0, 2), tolerance::series));
  EXPECT_TRUE(near(m.angular_acceleration, Eigen::Vector3d(0, 0, 1), tolerance::series));
}

TEST(AnyCurve, RoundTripsATypedCurve) {
  const Keyframes keys = five_keys();
  const auto typed = families::Slerp::curve(keys, {}).value();
  const AnyCurve erased(typed);
  for (const double t : sample_times(keys.times()))
    EXPECT_EQ(erased(t).coeffs(), typed.point(t, typed.knots().segment_at(t)).coeffs());
}

TEST(ConstantCurve, HoldsItsOnlyKeyForEver) {
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(1, 0.5, 0));
  const AnyCurve curve(ConstantCurve(3.0, q));
  EXPECT_EQ(curve.domain().start, 3.0);
  EXPECT_EQ(curve.domain().end, 3.0);
  for (const double t : {-5.0, 3.0, 100.0}) {
    EXPECT_EQ(curve(t).coeffs(), q.coeffs());
    EXPECT_TRUE(near(curve.motion(t), {.orientation = q}, {0, 0, 0, 0}));
  }
  EXPECT_TRUE(curve.checked_motion(3.0));
  EXPECT_FALSE(curve.checked_motion(3.1));
}

}}  // namespace orispline
