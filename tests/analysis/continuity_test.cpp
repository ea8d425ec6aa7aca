// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/continuity.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

#include "tumbling_keys.hpp"

namespace orispline { namespace {

using testing_support::about_x;

const std::vector<double> uniform_spacings(9, 0.5);

Continuity continuity_of(std::string_view family, const std::vector<double>& spacings) {
  return continuity_at_keys(make_curve(family, tumbling_keys(spacings)).value());
}

TEST(Continuity, OfSlerpIsTheDifferenceOfTheNeighbouringRates) {
  const auto keys = Keyframes::make({.times = {0.0, 1.0, 3.0, 4.0},
                                     .orientations = {about_x(0.0), about_x(0.5), about_x(2.5), about_x(2.5)}})
                        .value();

  const Continuity c = continuity_at_keys(make_curve("slerp", keys).value());  // rates 0.5, 1, 0 rad/s

  EXPECT_NEAR(c.angular_velocity.largest, 1.0, 1e-14);
  EXPECT_EQ(c.angular_velocity.key, 2u);
  EXPECT_NEAR(c.angular_velocity.magnitude, 1.0, 1e-14);
  EXPECT_NEAR(c.angular_velocity.relative, 1.0, 1e-14);
  EXPECT_EQ(c.order(), 0);
}

TEST(Continuity, MeasuresAJumpByTheFasterSideOfAKey) {
  for (const auto& turns : {std::vector{0.0, 0.1, 1.1}, std::vector{0.0, 1.0, 1.1}}) {  // rates 0.1, 1 and 1, 0.1 rad/s
    KeyframeData data{.times = {0.0, 1.0, 2.0}};
    for (const double turn : turns) data.orientations.push_back(about_x(turn));
    const Continuity c = continuity_at_keys(make_curve("slerp", Keyframes::make(std::move(data)).value()).value());
    EXPECT_NEAR(c.angular_velocity.magnitude, 1.0, 1e-14);
    EXPECT_NEAR(c.angular_velocity.relative, 0.9, 1e-14);
  }
}

TEST(Continuity, SeesARateThatIsLargestOnOneSideOfAKeyAndNowhereElse) {
  for (const auto& turns : {std::vector{0.0, 0.1, 1.1, 1.2, 1.3}, std::vector{0.0, 0.1, 0.2, 1.2, 1.3}}) {
    KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0, 4.0}};
    for (const double turn : turns) data.orientations.push_back(about_x(turn));
    const AnyCurve curve = make_curve("timed-c1", Keyframes::make(std::move(data)).value()).value();
    double largest = 0.0;  // about one axis the acceleration is linear in time from key to key
    for (const double t : curve.knots().times())
      for (const Side side : {Side::left, Side::right})
        largest = std::max(largest, curve.motion(t, side).angular_acceleration.norm());
    EXPECT_EQ(continuity_at_keys(curve).angular_acceleration.magnitude, largest);
  }
}

TEST(Continuity, IsAsDeclaredOnUniformKnots) {
  for (const FamilyInfo& family : families_info())
    EXPECT_EQ(continuity_of(family.name, uniform_spacings).order(), family.continuity_uniform) << family.name;
}

TEST(Continuity, IsAsDeclaredOnUnevenKnots) {
  for (const FamilyInfo& family : families_info())
    EXPECT_EQ(continuity_of(family.name, uneven_spacings).order(), family.continuity_uneven) << family.name;
}

TEST(Continuity, ShowsNoAngularVelocityJumpForTheTimedFamiliesAtSpacingRatiosOfTen) {
  for (const char* family : {"timed-c1", "timed-c2", "timed-c3", "timed-sextic"}) {
    const RateJump jump = continuity_of(family, uneven_spacings).angular_velocity;
    EXPECT_LT(jump.largest / jump.magnitude, 1e-12) << family;
  }
}

TEST(Continuity, OfQuinticOnUnevenKnotsIsTheStretchOfItsRateByTheSpacing) {
  const Keyframes keys =
      Keyframes::make({.times = {0.0, 1.0, 3.0}, .orientations = {about_x(0.0), about_x(0.6), about_x(1.4)}}).value();

  const RateJump jump = continuity_at_keys(make_curve("quintic", keys).value()).angular_velocity;

  // 2018 paper, C1 condition in the local parameter: ω = α (a + b)/h = 0.7/h on either side of the middle key.
  EXPECT_NEAR(jump.largest, 0.7 / 1.0 - 0.7 / 2.0, 1e-13);
  EXPECT_EQ(jump.key, 1u);
}

TEST(Continuity, TakesTheRoundingOfASteadyTurnForNoJump) {
  const auto keys = Keyframes::make({.times = {0.0, 0.7, 1.0, 3.1},
                                     .orientations = {about_x(0.0), about_x(0.7), about_x(1.0), about_x(3.1)}})
                        .value();
  EXPECT_EQ(continuity_at_keys(make_curve("timed-c1", keys).value()).order(), 3);
}

TEST(Continuity, OfOneKeyIsComplete) {
  const auto key = Keyframes::make({.times = {4.0}, .orientations = {about_x(1.0)}}).value();
  EXPECT_EQ(continuity_at_keys(make_curve("timed-c2", key).value()).order(), 3);
}

/// Turns about x at 1 rad/s, but from one time on so much farther.
class BrokenCurve {
 public:
  BrokenCurve(std::vector<double> times, double time, double jump)
      : knots_(std::move(times)), time_(time), jump_(jump) {}

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t) const noexcept {
    return exp<T>(Vector3<T>(t + T(value_of(t) < time_ ? 0.0 : jump_), T(0.0), T(0.0)));
  }

 private:
  Knots knots_;
  double time_, jump_;
};

TEST(Continuity, FindsWhereTheOrientationItselfJumpsBetweenKeys) {
  for (const double jump : {3.0, 0.8, -0.4}) {
    const AnyCurve curve = BrokenCurve({0.0, 1.0, 3.0, 5.0}, 1.7182818, jump);
    const Continuity c = continuity_at_keys(curve);
    EXPECT_EQ(c.order(), -1);
    EXPECT_NEAR(c.orientation.angle, std::abs(jump), 1e-12);
    EXPECT_NEAR(c.orientation.time, 1.7182818, 1e-12);
    EXPECT_EQ(c.orientation.key, 1u);
    EXPECT_EQ(c.angular_velocity.largest, 0.0);
    EXPECT_FALSE(shape_continuity_at_keys(curve).order());
    EXPECT_FALSE(shape_continuity_at_keys(curve).order_in_motion());
  }
}

TEST(Continuity, FindsNoJumpWhereACurveIsOnlyQuick) {
  const AnyCurve curve = make_curve("log-parabola", tumbling_keys({1.0, 1e-3, 60.0, 1e-3, 1.0})).value();
  EXPECT_EQ(continuity_at_keys(curve).orientation.angle, 0.0);
}

TEST(OrdersAtKeys, AreThoseOfEachKey) {
  const auto keys =
      Keyframes::make({.times = {0.0, 1.0, 2.0, 3.0, 4.0},
                       .orientations = {about_x(0.0), about_x(0.5), about_x(1.0), about_x(1.2), about_x(1.4)}})
          .value();
  EXPECT_EQ(orders_at_keys(make_curve("slerp", keys).value()), (std::vector{3, 3, 0, 3, 3}));
}

TEST(OrdersAtKeys, HaveTheOrderOfTheCurveAsTheirLeast) {
  for (const FamilyInfo& family : families_info())
    for (const auto& spacings : {uniform_spacings, uneven_spacings}) {
      const AnyCurve curve = make_curve(family.name, tumbling_keys(spacings)).value();
      const std::vector<int> orders = orders_at_keys(curve);
      ASSERT_EQ(orders.size(), curve.knots().times().size()) << family.name;
      EXPECT_EQ(orders.front(), 3) << family.name;
      EXPECT_EQ(orders.back(), 3) << family.name;
      EXPECT_EQ(std::ranges::min(orders), continuity_at_keys(curve).order()) << family.name;
    }
}

TEST(OrdersAtKeys, AreOneWhereALoopIsJoined) {
  const auto keys = Keyframes::make({.times = {0.0, 1.0, 2.0, 3.0},
                                     .orientations = {about_x(0.0), about_x(0.5), about_x(1.0), about_x(0.0)}})
                        .value();
  const AnyCurve curve = make_curve("slerp", keys).value();
  EXPECT_EQ(orders_at_keys(curve), (std::vector{3, 3, 0, 3}));
  EXPECT_EQ(orders_at_keys(curve, Seam::closed), (std::vector{0, 3, 0, 0}));
}

TEST(OrdersAtKeys, SayBeforeWhichKeyTheOrientationJumps) {
  const AnyCurve curve = BrokenCurve({0.0, 1.0, 3.0, 5.0}, 1.7182818, 0.8);
  EXPECT_EQ(orders_at_keys(curve), (std::vector{3, -1, 3, 3}));
}

TEST(OrdersAtKeys, OfOneKeyIsComplete) {
  const auto key = Keyframes::make({.times = {4.0}, .orientations = {about_x(1.0)}}).value();
  EXPECT_EQ(orders_at_keys(make_curve("timed-c2", key).value()), std::vector{3});
}

}}  // namespace orispline
