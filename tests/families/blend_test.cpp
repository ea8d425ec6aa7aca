// SPDX-License-Identifier: Apache-2.0
// Blended parabolas and circles: what they reproduce, how smooth they are, and where the circle gives way.
#include <gtest/gtest.h>

#include <families/same_curve.hpp>
#include <families/winding_keys.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::Circular;
using families::LogParabola;

const std::vector<double> uneven_times{0.0, 0.4, 1.5, 1.7, 2.6, 3.0, 4.1};

CurveOptions of_order(double order) { return {.parameters = {{"order", {order}}}}; }

/// Keys on a circle of S³ with its centre at that distance from the origin, the arc angle being 0.7 times the time.
struct KeysOnACircle {
  double centre;

  [[nodiscard]] Eigen::Quaterniond at(double t) const {
    const Eigen::Quaterniond frame = exp<double>(Eigen::Vector3d(0.3, -0.8, 1.1));
    const double radius = std::sqrt(1.0 - centre * centre), angle = 0.7 * t;
    return frame * Eigen::Quaterniond(radius * std::cos(angle), radius * std::sin(angle), centre, 0.0);
  }
  [[nodiscard]] KeyframeData keys(const std::vector<double>& times) const {
    KeyframeData data{.times = times};
    for (const double t : times) data.orientations.push_back(at(t));
    return data;
  }
};

template <class F>
class Blend : public testing::Test {};
using Blends = testing::Types<LogParabola, Circular>;
TYPED_TEST_SUITE(Blend, Blends, FamilyNames);

TYPED_TEST(Blend, IsAsSmoothInTimeAsItsOrderAndNoSmoother) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const Keyframes keys = keyframes(random_walk(441, 8, spacing, 0.8));
    for (const std::size_t order : {1u, 2u, 3u}) {
      const auto jumps = relative_jumps(typed_curve<TypeParam>(keys, of_order(static_cast<double>(order))));
      for (std::size_t k = 0; k <= order; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
      EXPECT_GE(jumps[order + 1], tolerance::visible_jump) << order;
    }
  }
}

TYPED_TEST(Blend, HasOrderTwoByDefault) {
  const Keyframes keys = keyframes(random_walk(442, 6, Spacing::uneven, 0.8));
  const AnyCurve plain = make_curve(TypeParam::info.name, keys).value();
  const AnyCurve second = make_curve({TypeParam::info.name, of_order(2)}, keys).value();
  for (const double t : sample_times(keys.times())) EXPECT_EQ(plain(t).coeffs(), second(t).coeffs());
}

TYPED_TEST(Blend, RefusesOrdersThatAreNotOneTwoOrThree) {
  const Keyframes keys = keyframes(random_walk(443, 4, Spacing::even));
  const auto message = [&](double order) {
    const auto curve = make_curve({TypeParam::info.name, of_order(order)}, keys);
    return curve ? "accepted" : curve.error().message;
  };
  const std::string name(TypeParam::info.name);
  EXPECT_EQ(message(4), name + ": order is 4, wanted 1 to 3");
  EXPECT_EQ(message(0), name + ": order is 0, wanted 1 to 3");
  EXPECT_EQ(message(1.5), name + ": order is 1.5, wanted a whole number");
}

TYPED_TEST(Blend, KeepsAConstantAccelerationAboutOneAxisAwayFromTheEnds) {
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  KeyframeData data{.times = uneven_times};
  const auto angle = [](double t) { return 0.3 * t + 0.15 * t * t; };
  for (const double t : uneven_times) data.orientations.push_back(exp<double>(angle(t) * axis));
  for (const double order : {1.0, 2.0, 3.0}) {
    const AnyCurve curve = make_curve({TypeParam::info.name, of_order(order)}, keyframes(data)).value();
    for (double t = uneven_times[1]; t < uneven_times[5]; t += 0.07) {
      const Motion wanted{.orientation = exp<double>(angle(t) * axis),
                          .angular_velocity = (0.3 + 0.3 * t) * axis,
                          .angular_acceleration = 0.3 * axis};
      EXPECT_TRUE(near(curve.motion(t), wanted, same_curve)) << t;
    }
  }
}

TYPED_TEST(Blend, KeepsAParabolaOfPositionsAwayFromTheEnds) {
  KeyframeData data = random_walk(444, uneven_times.size(), Spacing::even);
  data.times = uneven_times;
  const Eigen::Vector3d velocity(1, -2, 0.5), bend(0.3, 0.4, -0.1);
  for (const double t : uneven_times) data.positions.push_back(t * velocity + t * t * bend);
  const AnyPath path = make_pose_curve(TypeParam::info.name, keyframes(data))->position.value();
  for (double t = uneven_times[1]; t < uneven_times[5]; t += 0.07) {
    EXPECT_TRUE(near(path.linear_motion(t).position, t * velocity + t * t * bend, tolerance::algebra));
    EXPECT_TRUE(near(path.linear_motion(t).acceleration, 2.0 * bend, tolerance::rates));
  }
}

TYPED_TEST(Blend, IsTheSameCurveWhenKeysAndTimeAreReversed) {
  const KeyframeData data = random_walk(445, 6, Spacing::uneven, 0.8);
  KeyframeData reversed;
  for (std::size_t i = 6; i-- > 0;) {
    reversed.times.push_back(-data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  const AnyCurve forth = make_curve(TypeParam::info.name, keyframes(data)).value();
  const AnyCurve back = make_curve(TypeParam::info.name, keyframes(reversed)).value();
  for (const double t : sample_times(data.times)) EXPECT_TRUE(near(back(-t), forth(t), tolerance::series)) << t;
}

TYPED_TEST(Blend, TurnsByTheAnglesOfItsOwnPathAboutOneAxisHoweverFarItWinds) {
  for (const double order : {1.0, 2.0, 3.0})
    expect_the_turn_of_its_path({TypeParam::info.name, of_order(order)}, winding_keys_about_one_axis());
}

TYPED_TEST(Blend, IsAsSmoothWhereItWinds) {
  for (const double aside : {0.0, 1e-12, 1e-8})
    for (const std::size_t order : {1u, 2u, 3u}) {
      const Keyframes keys = winding_keys_about_one_axis(aside);
      const auto jumps = relative_jumps(typed_curve<TypeParam>(keys, of_order(static_cast<double>(order))));
      for (std::size_t k = 0; k <= order; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
    }
}

TEST(Circular, StaysOnACircleOfS3ThatItsKeysLieOn) {
  for (const double centre : {0.0, 1e-12, 1e-6, 1e-3, 0.3, 0.8, 0.99}) {
    const KeysOnACircle circle{centre};
    const AnyCurve curve = make_curve("circular", keyframes(circle.keys(uneven_times))).value();
    for (double t = uneven_times[1]; t < uneven_times[5]; t += 0.05)
      EXPECT_TRUE(near(curve(t), circle.at(t), tolerance::algebra)) << "centre at " << centre << ", t = " << t;
  }
}

TEST(Circular, RunsOnItsCircleAtAConstantRateWhateverTheRadius) {
  for (const double centre : {0.0, 1e-9, 0.5}) {
    const KeysOnACircle circle{centre};
    const AnyCurve curve = make_curve("circular", keyframes(circle.keys(uneven_times))).value();
    const double speed = 2.0 * 0.7 * std::sqrt(1.0 - centre * centre);
    for (double t = uneven_times[1]; t < uneven_times[5]; t += 0.05)
      EXPECT_NEAR(curve.motion(t).angular_velocity.norm(), speed, tolerance::series) << "centre at " << centre;
  }
}

TEST(Circular, IsAccurateOnShortArcs) {
  // Steps of 1e-5 rad: a centre found from such keys would have lost half its digits.
  const KeysOnACircle circle{0.3};
  std::vector<double> times = uneven_times;
  for (double& t : times) t *= 1e-4;
  const AnyCurve curve = make_curve("circular", keyframes(circle.keys(times))).value();
  const double speed = 2.0 * 0.7 * std::sqrt(1.0 - 0.3 * 0.3);
  for (double t = times[1]; t < times[5]; t += 5e-6)
    EXPECT_NEAR(curve.motion(t).angular_velocity.norm(), speed, 1e4 * tolerance::series);
}

TEST(Circular, IsLogParabolaAboutOneAxis) {
  KeyframeData data{.times = uneven_times};
  for (const double angle : {0.0, 0.9, 1.0, 1.3, 1.9, 2.0, 2.8})  // onwards: on the way back a circle goes all round
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.3, 0.2, -0.7)) *
                                exp<double>(angle * Eigen::Vector3d(0.48, -0.6, 0.64)));
  const Keyframes keys = keyframes(data);
  const AnyCurve circular = make_curve("circular", keys).value(), parabola = make_curve("log-parabola", keys).value();
  for (const double t : sample_times(keys.times(), 9))
    EXPECT_TRUE(near(circular.motion(t), parabola.motion(t), same_curve)) << t;
}

TEST(Circular, IsLogParabolaAboutOneAxisAlsoWhereItTurnsBack) {
  KeyframeData data{.times = uneven_times};
  for (const double angle : {0.0, 0.9, 0.2, 1.3, 1.2, 2.0, 0.8})
    data.orientations.push_back(exp<double>(angle * Eigen::Vector3d(0.48, -0.6, 0.64)));
  const Keyframes keys = keyframes(data);
  const AnyCurve circular = make_curve("circular", keys).value(), parabola = make_curve("log-parabola", keys).value();
  for (const double t : sample_times(keys.times(), 9))
    EXPECT_TRUE(near(circular.motion(t), parabola.motion(t), same_curve)) << t;
}

TEST(Circular, IsLogParabolaWhereKeysAreTooCloseToTellACircle) {
  const Keyframes keys = keyframes(random_walk(446, 6, Spacing::uneven, 1e-7));
  const AnyCurve circular = make_curve("circular", keys).value(), parabola = make_curve("log-parabola", keys).value();
  for (const double t : sample_times(keys.times())) EXPECT_EQ(circular(t).coeffs(), parabola(t).coeffs());
}

}}  // namespace orispline
