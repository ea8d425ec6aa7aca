// SPDX-License-Identifier: Apache-2.0
// nu: Nielson's construction, its ends, its limits of tension, and its refusals.
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/io/key_file.hpp>
#include <support/cubic_spline_by_definition.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

#include "support/places.hpp"

namespace orispline { namespace {

using namespace testing_support;

Expected<AnyCurve> made(const KeyframeData& data, std::vector<double> nu = {0.0}, End start = {}, End end = {}) {
  return make_curve({"nu", {.parameters = {{"nu", std::move(nu)}}, .start = std::move(start), .end = std::move(end)}},
                    keyframes(data));
}

AnyCurve nu_curve(const KeyframeData& data, std::vector<double> nu = {0.0}, End start = {}, End end = {}) {
  return made(data, std::move(nu), std::move(start), std::move(end)).value();
}

/// Keys that turn about one axis, and their rotation vectors.
struct TurnsAboutOneAxis {
  KeyframeData data;
  std::vector<Eigen::Vector3d> turns;
};

TurnsAboutOneAxis about_one_axis(std::uint64_t seed, std::size_t count) {
  TurnsAboutOneAxis track{random_walk(seed, count, Spacing::uneven), {}};
  Dice dice(seed + 1);
  for (Eigen::Quaterniond& q : track.data.orientations) {
    track.turns.push_back(dice.between(-0.4, 0.4) * Eigen::Vector3d(0.48, -0.6, 0.64));
    q = exp<double>(track.turns.back());
  }
  return track;
}

TEST(Nu, IsTheNuSplineAboutOneAxisWithEveryEnd) {
  const std::vector<double> nu{5.0, 1.0, 0.0, 2.0, 0.4, -0.1, 8.0, 3.0};
  const Eigen::Vector3d rate(0.24, -0.3, 0.32);
  const auto [data, turns] = about_one_axis(531, nu.size());
  using Ends = CubicSplineByDefinition::Ends;
  for (const auto& [end, wanted] :
       {std::pair{End{.rule = EndRule::natural}, Ends{}}, std::pair{End{EndRule::clamped, rate}, Ends{rate, rate}},
        std::pair{End{.rule = EndRule::rest}, Ends{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}}}) {
    const CubicSplineByDefinition spline(data.times, turns, wanted, nu);
    const AnyCurve c = nu_curve(data, nu, end, end);
    for (const double t : sample_times(data.times)) {
      const std::size_t segment = c.knots().segment_at(t);
      EXPECT_TRUE(near(c(t), exp<double>(spline.derivative(0, t, segment)), tolerance::series)) << t;
      EXPECT_TRUE(near(c.motion(t).angular_velocity, spline.derivative(1, t, segment), tolerance::rates)) << t;
      EXPECT_TRUE(near(c.motion(t).angular_acceleration, spline.derivative(2, t, segment), tolerance::rates)) << t;
    }
  }
}

TEST(Nu, HasTheGivenRatesAtClampedEndsWithAnyTension) {
  const Eigen::Vector3d first(0.4, -1.2, 0.3), last(-0.7, 0.1, 0.9);
  const KeyframeData data = random_walk(532, 8, Spacing::uneven, 0.8);
  for (const double nu : {0.0, 2.0, 20.0}) {
    const AnyCurve c = nu_curve(data, {nu}, {EndRule::clamped, first}, {EndRule::clamped, last});
    EXPECT_TRUE(near(c.motion(c.domain().start).angular_velocity, first, tolerance::series)) << nu;
    EXPECT_TRUE(near(c.motion(c.domain().end).angular_velocity, last, tolerance::series)) << nu;
  }
}

TEST(Nu, StandsStillAtEndsAtRest) {
  const End rest{.rule = EndRule::rest};
  const AnyCurve c = nu_curve(random_walk(533, 8, Spacing::uneven, 0.8), {1.0}, rest, rest);
  for (const double t : {c.domain().start, c.domain().end})
    EXPECT_LE(c.motion(t).angular_velocity.norm(), tolerance::series);
}

TEST(Nu, HasNoAccelerationAtNaturalEndsWithAnyTension) {
  for (const double nu : {0.0, 2.0, 20.0}) {
    const AnyCurve c = nu_curve(random_walk(547, 8, Spacing::uneven, 0.8), {nu});
    for (const double t : {c.domain().start, c.domain().end}) {
      EXPECT_LE(c.motion(t).angular_acceleration.norm(), tolerance::rates) << nu;
      EXPECT_GE(c.motion(t).angular_velocity.norm(), 0.05) << nu;
    }
  }
}

TEST(Nu, IsC1AtUnevenTimesAndNoSmootherWithAnyTension) {
  for (const double nu : {0.0, 2.0, 20.0}) {
    const auto jumps = relative_jumps(nu_curve(random_walk(534, 30, Spacing::uneven, 0.8), {nu}));
    EXPECT_LE(jumps[0], tolerance::continuity) << nu;
    EXPECT_LE(jumps[1], tolerance::continuity) << nu;
    EXPECT_GE(jumps[2], tolerance::visible_jump) << nu;
  }
}

TEST(Nu, LeavesEveryKeyStraightAlongItsInnerPoints) {
  // Published: the key lies on the arc between the inner points beside it, which the steps divide.
  const KeyframeData data = random_walk(535, 8, Spacing::uneven, 0.8);
  const AnyCurve c = nu_curve(data, {1.5});
  for (std::size_t i = 1; i + 1 < data.times.size(); ++i)
    EXPECT_TRUE(near(c.motion(data.times[i], Side::left).angular_velocity, c.motion(data.times[i]).angular_velocity,
                     tolerance::rates));
}

TEST(Nu, OfTwoKeysIsTheGreatArcAtConstantRate) {
  const KeyframeData data = random_walk(536, 2, Spacing::even, 2.5);
  const Eigen::Vector3d rate =
      increment<double>(data.orientations[0], data.orientations[1]) / (data.times[1] - data.times[0]);
  const AnyCurve c = nu_curve(data, {3.0});
  for (const double t : sample_times(data.times, 7))
    EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << t;
}

TEST(Nu, TendsToSlerpsThatStopAtEveryKeyAsOneOverNu) {
  const KeyframeData data = random_walk(537, 9, Spacing::uneven, 0.8);
  const End rest{.rule = EndRule::rest};
  const auto distance = [&](double nu) {
    return largest_distance_from_stopping_slerps(nu_curve(data, {nu}, rest, rest), data);
  };
  // The rate left at a key is the jump there, from 6 d/h² of either stopping slerp, over ν; it leads 4/27 h away.
  constexpr double turn = 0.8, shortest = 0.1, longest = 1.0;
  EXPECT_LE(distance(1e8), 1e-8 * 2.0 * 6.0 * turn / (shortest * shortest) * 4.0 / 27.0 * longest);
  EXPECT_NEAR(distance(1e5) / distance(1e6), 10.0, 0.1);
}

TEST(Nu, IsTheSameBackwardsInTimeWithItsNuBackwards) {
  const KeyframeData data = random_walk(538, 6, Spacing::uneven, 0.8);
  const std::vector<double> nu{0.0, 1.0, 4.0, 0.3, 7.0, 0.0};
  EXPECT_LE(largest_distance_from_backwards(nu_curve(data, nu), nu_curve(reversed(data), {nu.rbegin(), nu.rend()})),
            tolerance::series);
}

TEST(Nu, ScalesItsNuWithTheClock) {
  const KeyframeData data = random_walk(539, 7, Spacing::uneven, 0.8);
  const double slower = 4.0, shift = 11.0;
  KeyframeData rescaled = data;
  for (double& t : rescaled.times) t = slower * t + shift;
  const AnyCurve c = nu_curve(data, {3.0}), d = nu_curve(rescaled, {3.0 / slower});
  for (const double t : sample_times(data.times))
    EXPECT_TRUE(near(d(slower * t + shift), c(t), tolerance::series)) << t;
}

TEST(Nu, DiffersFromTheExactConditionOnTheSphere) {
  const KeyframeData data = random_walk(540, 7, Spacing::even, 0.8);
  const AnyCurve exact = make_curve({"nu-exact", {.parameters = {{"nu", {1.0}}}}}, keyframes(data)).value();
  const double distance = largest_distance(nu_curve(data, {1.0}), exact);
  EXPECT_LE(distance, 0.05);
  EXPECT_GE(distance, tolerance::visible_jump);
}

TEST(Nu, CarriesPositionsOnTheNuSpline) {
  const KeyframeData data = posed_walk(541, 7, Spacing::uneven, 0.8);
  const std::vector<double> nu{0.0, 1.0, 40.0, 0.0, 0.3, 2.0, 0.0};
  const PoseCurve pose = make_pose_curve({"nu", {.parameters = {{"nu", nu}}}}, keyframes(data)).value();
  const CubicSplineByDefinition spline(data.times, data.positions, {}, nu);
  for (const double t : sample_times(data.times))
    EXPECT_TRUE(near(pose.position->linear_motion(t).position,
                     spline.derivative(0, t, pose.orientation.knots().segment_at(t)), tolerance::series));
}

TEST(Nu, RefusesANuWithAPoleAndNamesItsKey) {
  KeyframeData data = random_walk(542, 4, Spacing::even, 0.8);
  data.times = {0.0, 1.0, 3.0, 4.0};
  // -2 (h₀ + h₁)/(h₀ h₁) = -2 (1 + 2)/(1 · 2) at key 1.
  for (const double nu : {-3.0, -7.5}) {
    const auto c = made(data, {0.0, nu, 0.0, 0.0});
    ASSERT_FALSE(c) << nu;
    EXPECT_EQ(c.error().code, ErrorCode::bad_argument);
    EXPECT_EQ(c.error().where.key, 1u);
    EXPECT_EQ(c.error().message,
              "nu: nu is " + std::string(nu == -3.0 ? "-3" : "-7.5") + ", wanted more than -3 between these key times");
  }
  EXPECT_TRUE(made(data, {0.0, -0.5, 0.0, 0.0}));
}

TEST(Nu, SaysWhereAndHowFarItDoesNotConverge) {
  std::size_t refused = 0;
  for (const std::uint64_t seed : {543u, 544u, 545u, 546u}) {
    const KeyframeData data = random_walk(seed, 12, Spacing::uneven, 2.5);
    const auto c = made(data);
    if (c) continue;
    ++refused;
    EXPECT_EQ(c.error().code, ErrorCode::not_converged);
    ASSERT_TRUE(c.error().where.key);
    EXPECT_LT(*c.error().where.key, data.times.size());
    const std::string& message = c.error().message;
    EXPECT_TRUE(message.starts_with("nu does not converge for these keys: the residual stays at ")) << message;
    EXPECT_NE(message.find(", wanted 1e-12; it converges where every step turns 0."), std::string::npos) << message;
    EXPECT_TRUE(message.ends_with(" times as far; put keys in between, or take a local method such as timed-c2"))
        << message;
  }
  EXPECT_GE(refused, 1u);
}

TEST(Nu, SolvesAFlightOfThreeHundredKeys) {
  const auto file = io::read_keys(testing_support::in_project("examples/data/flight_truth.csv"));
  ASSERT_TRUE(file) << describe(file.error());
  KeyframeData data;
  for (std::size_t i = 0; i < file->data.times.size(); i += 16) {
    data.times.push_back(file->data.times[i]);
    data.orientations.push_back(file->data.orientations[i]);
  }
  ASSERT_GE(data.times.size(), 300u);
  for (const char* family : {"nu", "nu-exact", "global-c2", "rotation-spline", "bspline-through"}) {
    const auto c = make_curve(family, keyframes(data));
    ASSERT_TRUE(c) << describe(c.error());
    double largest = 0.0;
    for (std::size_t i = 0; i < file->data.times.size(); ++i)
      largest = std::max(largest, angular_distance((*c)(file->data.times[i]), file->data.orientations[i]));
    EXPECT_LE(largest, 0.005) << family;  // [rad], keys 0.16 s apart
  }
}

TEST(Nu, RefusesAnEndRateWhoseHandleWouldWindRound) {
  const KeyframeData data = random_walk(557, 5, Spacing::uneven);
  const double largest =
      6.0 * std::numbers::pi / (data.times[4] - data.times[3]);  // a handle is a third of the rate times the step
  const auto with_end_rate = [&](double rate) {
    return made(data, {0.0}, {}, End{EndRule::clamped, Eigen::Vector3d(0.0, rate, 0.0)});
  };
  const auto refused = with_end_rate(1.01 * largest);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(refused.error().where.key, 4u);
  const auto below = with_end_rate(0.3 * largest);
  ASSERT_TRUE(below) << describe(below.error());
  EXPECT_NEAR(below->motion(data.times[4]).angular_velocity.y(), 0.3 * largest, tolerance::rates * largest);
}

}}  // namespace orispline
