// SPDX-License-Identifier: Apache-2.0
// bspline-through: its control orientations give back the keys, with either kind of knots beyond the ends.
#include <gtest/gtest.h>

#include <orispline/families/bspline_through.hpp>
#include <orispline/families/registry.hpp>
#include <support/cubic_spline_by_definition.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr const char* phantoms[] = {"reflect", "equal"};

CurveOptions with_phantom(const char* phantom, const End& start = {}, const End& end = {}) {
  return {.choices = {{"phantom", phantom}}, .start = start, .end = end};
}

AnyCurve bspline_through_curve(const KeyframeData& data, const CurveOptions& options = {}) {
  return make_curve({"bspline-through", options}, keyframes(data)).value();
}

TEST(BSplineThrough, PassesThroughItsKeysWithEveryPhantomAndEnd) {
  const KeyframeData data = random_walk(571, 9, Spacing::uneven, 0.8);
  for (const char* phantom : phantoms)
    for (const EndRule rule : {EndRule::natural, EndRule::clamped, EndRule::rest}) {
      End end{.rule = rule};
      if (rule == EndRule::clamped) end.angular_velocity = {0.3, -0.2, 0.5};
      const AnyCurve c = bspline_through_curve(data, with_phantom(phantom, end, end));
      for (std::size_t i = 0; i < data.times.size(); ++i)
        for (const Side side : {Side::left, Side::right})
          EXPECT_TRUE(near(c.motion(data.times[i], side).orientation, data.orientations[i], tolerance::series))
              << phantom << ", " << name_of(rule) << ", key " << i;
    }
}

TEST(BSplineThrough, HasControlOrientationsThatGiveBackTheKeysByTheirSixths) {
  // On even times a cubic B-spline is at a knot at one sixth, four sixths and one sixth of three controls.
  const KeyframeData data = random_walk(572, 9, Spacing::even, 0.8);
  const Keyframes keys = keyframes(data);
  const FamilySettings settings = settle(families::BSplineThrough::info, {}, keys.size()).value();
  const auto curve = families::BSplineThrough::curve(keys, settings).value();
  const auto& [bases, increments] = curve.polygon();
  ASSERT_EQ(bases.size(), 8u);
  ASSERT_EQ(increments.size(), 10u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Eigen::Quaterniond at_key =
        bases[i] * exp<double>(5.0 / 6.0 * increments[i]) * exp<double>(1.0 / 6.0 * increments[i + 1]);
    EXPECT_TRUE(near(at_key, data.orientations[i], tolerance::series)) << "key " << i;
    if (i > 0) {
      EXPECT_TRUE(near(bases[i], bases[i - 1] * exp<double>(increments[i - 1]), tolerance::series)) << i;
    }
  }
}

TEST(BSplineThrough, FindsTheBSplineThatTheKeysWereTakenFrom) {
  // The family bspline on control keys runs through orientations at the knots: these as keys, with its end rates, must
  // give it back.
  const KeyframeData controls = random_walk(573, 9, Spacing::even, 0.8);
  const AnyCurve wanted = make_curve("bspline", keyframes(controls)).value();
  KeyframeData data{.times = controls.times};
  for (const double t : data.times) data.orientations.push_back(wanted(t));
  const End start{EndRule::clamped, wanted.motion(data.times.front()).angular_velocity};
  const End end{EndRule::clamped, wanted.motion(data.times.back()).angular_velocity};
  for (const char* phantom : phantoms) {
    const AnyCurve found = bspline_through_curve(data, with_phantom(phantom, start, end));
    for (const double t : sample_times(data.times, 7)) {
      EXPECT_TRUE(near(found(t), wanted(t), tolerance::series)) << t;
      EXPECT_TRUE(near(found.motion(t).angular_acceleration, wanted.motion(t).angular_acceleration, tolerance::rates));
    }
  }
}

TEST(BSplineThrough, HasTheGivenRatesAtClampedEnds) {
  const Eigen::Vector3d first(0.4, -1.2, 0.3), last(-0.7, 0.1, 0.9);
  const KeyframeData data = random_walk(574, 8, Spacing::uneven, 0.8);
  for (const char* phantom : phantoms) {
    const AnyCurve c =
        bspline_through_curve(data, with_phantom(phantom, {EndRule::clamped, first}, {EndRule::clamped, last}));
    EXPECT_TRUE(near(c.motion(data.times.front()).angular_velocity, first, tolerance::series)) << phantom;
    EXPECT_TRUE(near(c.motion(data.times.back()).angular_velocity, last, tolerance::series)) << phantom;
  }
}

TEST(BSplineThrough, StandsStillAtEndsAtRest) {
  const KeyframeData data = random_walk(575, 8, Spacing::uneven, 0.8);
  for (const char* phantom : phantoms) {
    const AnyCurve c =
        bspline_through_curve(data, with_phantom(phantom, {.rule = EndRule::rest}, {.rule = EndRule::rest}));
    for (const double t : {data.times.front(), data.times.back()}) {
      EXPECT_LE(c.motion(t).angular_velocity.norm(), tolerance::series) << phantom;
      EXPECT_GE(c.motion(t).angular_acceleration.norm(), 0.1) << phantom;
    }
  }
}

TEST(BSplineThrough, DoesNotAccelerateAtNaturalEndsWhereItsKnotsAreMirrored) {
  for (const auto& [phantom, spacing] : {std::pair{"reflect", Spacing::even}, std::pair{"reflect", Spacing::uneven},
                                         std::pair{"equal", Spacing::even}}) {
    const AnyCurve c = bspline_through_curve(random_walk(576, 8, spacing, 0.8), with_phantom(phantom));
    for (const double t : {c.domain().start, c.domain().end}) {
      EXPECT_LE(c.motion(t).angular_acceleration.norm(), tolerance::rates) << phantom;
      EXPECT_GE(c.motion(t).angular_velocity.norm(), 0.1) << phantom;
    }
  }
}

TEST(BSplineThrough, DependsOnItsPhantomsOnUnevenTimesOnly) {
  const auto distance = [](Spacing spacing) {
    const KeyframeData data = random_walk(577, 8, spacing, 0.8);
    return largest_distance(bspline_through_curve(data, with_phantom("reflect")),
                            bspline_through_curve(data, with_phantom("equal")));
  };
  EXPECT_LE(distance(Spacing::even), tolerance::algebra);
  EXPECT_GE(distance(Spacing::uneven), tolerance::visible_jump);
}

TEST(BSplineThrough, IsC2OnLongTracksAtUnevenTimes) {
  for (const char* phantom : phantoms) {
    const auto jumps =
        relative_jumps(bspline_through_curve(random_walk(578, 60, Spacing::uneven, 0.8), with_phantom(phantom)));
    for (const std::size_t order : {0u, 1u, 2u}) EXPECT_LE(jumps[order], tolerance::continuity) << phantom;
    EXPECT_GE(jumps[3], tolerance::visible_jump) << phantom;
  }
}

TEST(BSplineThrough, OfTwoKeysIsTheGreatArcAtConstantRate) {
  const KeyframeData data = random_walk(579, 2, Spacing::even, 2.5);
  const Eigen::Vector3d rate =
      increment<double>(data.orientations[0], data.orientations[1]) / (data.times[1] - data.times[0]);
  for (const char* phantom : phantoms) {
    const AnyCurve c = bspline_through_curve(data, with_phantom(phantom));
    for (const double t : sample_times(data.times, 7))
      EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << phantom;
  }
}

TEST(BSplineThrough, IsAnotherCurveBackwardsInTime) {
  const KeyframeData data = random_walk(580, 8, Spacing::even, 0.8);
  const double distance =
      largest_distance_from_backwards(bspline_through_curve(data), bspline_through_curve(reversed(data)));
  EXPECT_GE(distance, tolerance::visible_jump);
  EXPECT_LE(distance, 0.3);
}

TEST(BSplineThrough, IsTheSameOnAnotherClock) {
  const KeyframeData data = random_walk(581, 7, Spacing::uneven, 0.8);
  KeyframeData rescaled = data;
  for (double& t : rescaled.times) t = 4.0 * t + 11.0;
  const AnyCurve c = bspline_through_curve(data), d = bspline_through_curve(rescaled);
  for (const double t : sample_times(data.times)) EXPECT_TRUE(near(d(4.0 * t + 11.0), c(t), tolerance::series)) << t;
}

TEST(BSplineThrough, CarriesPositionsOnTheNaturalCubicSpline) {
  const KeyframeData data = posed_walk(582, 9, Spacing::uneven, 0.8);
  const PoseCurve pose = make_pose_curve("bspline-through", keyframes(data)).value();
  const CubicSplineByDefinition spline(data.times, data.positions);
  for (const double t : sample_times(data.times))
    EXPECT_TRUE(near(pose.position->linear_motion(t).position,
                     spline.derivative(0, t, pose.orientation.knots().segment_at(t)), tolerance::series));
}

/// The keys with all increments that many times as long.
KeyframeData with_increments_times(double share, const KeyframeData& data) {
  KeyframeData shorter = data;
  for (std::size_t i = 1; i < data.orientations.size(); ++i)
    shorter.orientations[i] = shorter.orientations[i - 1] *
                              exp<double>(share * increment<double>(data.orientations[i - 1], data.orientations[i]));
  return shorter;
}

TEST(BSplineThrough, ConvergesForTheShorterIncrementsThatItNamesWithTheRateShortenedToo) {
  const Eigen::Vector3d rate(40.0, -30.0, 20.0);
  const std::string claim = "it converges where every step turns ";
  std::size_t named = 0;
  for (std::uint64_t seed = 587; seed < 597; ++seed) {
    const KeyframeData data = random_walk(seed, 8, Spacing::even, 2.5);
    for (const bool at_start : {true, false}) {
      const auto clamped = [&](double share) -> CurveOptions {
        const End end{EndRule::clamped, share * rate};
        return at_start ? CurveOptions{.start = end} : CurveOptions{.end = end};
      };
      const auto refused = make_curve({"bspline-through", clamped(1.0)}, keyframes(data));
      if (refused) continue;
      const std::string& message = refused.error().message;
      ASSERT_NE(message.find(claim), std::string::npos) << message;
      const double share = 0.95 * std::stod(message.substr(message.find(claim) + claim.size()));
      ++named;
      EXPECT_TRUE(make_curve({"bspline-through", clamped(share)}, keyframes(with_increments_times(share, data))))
          << message;
    }
  }
  EXPECT_GE(named, 5u);
}

TEST(BSplineThrough, SaysWhereAndHowFarItDoesNotConverge) {
  std::size_t refused = 0;
  for (const std::uint64_t seed : {583u, 584u, 585u, 586u}) {
    const KeyframeData data = random_walk(seed, 12, Spacing::uneven, 2.5);
    const auto c = make_curve("bspline-through", keyframes(data));
    if (c) continue;
    ++refused;
    EXPECT_EQ(c.error().code, ErrorCode::not_converged);
    ASSERT_TRUE(c.error().where.key);
    EXPECT_LT(*c.error().where.key, data.times.size());
    const std::string& message = c.error().message;
    EXPECT_TRUE(message.starts_with("bspline-through does not converge for these keys: the residual stays at "))
        << message;
    EXPECT_NE(message.find(", wanted 1e-12; it converges where every step turns 0."), std::string::npos) << message;
  }
  EXPECT_GE(refused, 1u);
}

}}  // namespace orispline
