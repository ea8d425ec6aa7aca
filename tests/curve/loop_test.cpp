// SPDX-License-Identifier: Apache-2.0
// Closing a loop: what is accepted, and the words in which the rest is refused.
#include <limits>
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/curve/loop.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

Eigen::Quaterniond about_z(double angle) { return exp<double>(Eigen::Vector3d(0, 0, angle)); }

/// Keys at 0, 1, 2, … s turned about one axis.
KeyframeData turned(const std::vector<double>& angles) {
  KeyframeData data;
  for (const double angle : angles) {
    data.times.push_back(static_cast<double>(data.times.size()));
    data.orientations.push_back(about_z(angle));
  }
  return data;
}

struct BadLoop {
  const char* name;
  KeyframeData keys;
  CurveOptions options;
  ErrorCode code;
  const char* message;  ///< as `describe` puts it
};

void PrintTo(const BadLoop& test, std::ostream* out) { *out << test.name; }

KeyframeData with_positions(KeyframeData data, const Eigen::Vector3d& last) {
  data.positions.assign(data.times.size(), Eigen::Vector3d::Zero());
  data.positions.back() = last;
  return data;
}

class LoopRefuses : public testing::TestWithParam<BadLoop> {};

TEST_P(LoopRefuses, WithWhatWasFoundAndWhatWasWanted) {
  const auto c = make_pose_curve({"timed-c2", GetParam().options}, keyframes(GetParam().keys));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, GetParam().code);
  EXPECT_EQ(describe(c.error()), GetParam().message);
}

using enum ErrorCode;

INSTANTIATE_TEST_SUITE_P(
    Bad, LoopRefuses,
    testing::Values(
        BadLoop{"LastKeyIsNotTheFirst",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{}},
                bad_data,
                "key 2: the last key is 57.2958 degrees from the first, wanted the first one again, or `period` for a "
                "later return"},
        BadLoop{
            "LastPositionIsNotTheFirst",
            with_positions(turned({0.0, 0.5, 0.0}), {0, 3, 4}),
            {.loop = Loop{}},
            bad_data,
            "key 2: the last key is 5 m from the first, wanted the first one again, or `period` for a later return"},
        BadLoop{"PeriodIsTooShort",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{1.5}},
                bad_argument,
                "the period is 1.5 s, wanted a finite number greater than the keys' span of 2 s"},
        BadLoop{"PeriodEndsAtTheLastKey",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{2.0}},
                bad_data,
                "key 2: the last key is 57.2958 degrees from the first, wanted the first one again, or `period` for a "
                "later return"},
        BadLoop{"PeriodIsNegative",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{-3.0}},
                bad_argument,
                "the period is -3 s, wanted a finite number greater than the keys' span of 2 s"},
        BadLoop{"PeriodIsNotANumber",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{std::numeric_limits<double>::quiet_NaN()}},
                bad_argument,
                "the period is nan s, wanted a finite number greater than the keys' span of 2 s"},
        BadLoop{"PeriodIsInfinite",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{std::numeric_limits<double>::infinity()}},
                bad_argument,
                "the period is inf s, wanted a finite number greater than the keys' span of 2 s"},
        BadLoop{"PeriodIsTooLong",
                turned({0.0, 0.5, 1.0}),
                {.loop = Loop{1e200}},
                bad_argument,
                "the period is 1e+200 s, wanted a finite number greater than the keys' span of 2 s"},
        BadLoop{"OneKey", turned({0.3}), {.loop = Loop{1.0}}, bad_data, "a closed curve needs 2 keys, found 1"},
        BadLoop{"OneKeyTwice",
                turned({0.3, 0.3}),
                {.loop = Loop{}},
                bad_data,
                "a closed curve needs 2 different keys, found 1"},
        BadLoop{"StartRule",
                turned({0.0, 0.5, 1.0}),
                {.start = {.rule = EndRule::natural}, .loop = Loop{3.0}},
                bad_argument,
                "timed-c2: a closed curve has no ends, found an end rule"},
        BadLoop{"EndRule",
                turned({0.0, 0.5, 1.0}),
                {.end = {.rule = EndRule::clamped, .angular_velocity = {1, 0, 0}}, .loop = Loop{3.0}},
                bad_argument,
                "timed-c2: a closed curve has no ends, found an end rule"},
        BadLoop{"TooManyParameters",
                turned({0.0, 0.5, 1.0}),
                {.parameters = {{"tension", {0.5, 0.5, 0.5, 0.5}}}, .loop = Loop{3.0}},
                bad_argument,
                "timed-c2: found 4 values of tension, wanted 1 or one per key (3)"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Loop, TakesAClosingKeyWithinRounding) {
  KeyframeData data = turned({0.0, 0.5, 1.0, 0.4 * closing_tolerance});
  EXPECT_TRUE(make_curve({"timed-c2", {.loop = Loop{}}}, keyframes(data)));
  data.orientations.back() = about_z(4.0 * closing_tolerance);
  EXPECT_FALSE(make_curve({"timed-c2", {.loop = Loop{}}}, keyframes(data)));
}

TEST(Loop, MayStateThePeriodThatItsClosingKeyGives) {
  const Keyframes keys = keyframes(turned({0.0, 0.5, 1.0, 0.0}));
  const AnyCurve stated = make_curve({"timed-c2", {.loop = Loop{3.0}}}, keys).value();
  const AnyCurve found = make_curve({"timed-c2", {.loop = Loop{}}}, keys).value();
  for (const double t : sample_times(found.knots().times())) EXPECT_EQ(stated(t).coeffs(), found(t).coeffs());
}

TEST(ClosedKeys, AreRefusedWhereTheClosingStepIsTooUneven) {
  KeyframeData data = turned({0.0, 0.5, 1.0});
  data.times = {0.0, 1e-9, 2e-9};
  EXPECT_TRUE(closed_keys(keyframes(data), Loop{9e4}));
  const auto closed = closed_keys(keyframes(data), Loop{2e5});
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message,
            "the closing step is 200000 s and one beside it 1e-09 s, wanted neither longer than 1e+14 times the other");
}

TEST(ClosedKeys, LeaveTheClosingKeyOut) {
  const ClosedKeys closed = closed_keys(keyframes(turned({0.0, 0.5, 1.0, 0.0})), Loop{}).value();
  EXPECT_EQ(closed.keys.size(), 3u);
  EXPECT_EQ(closed.closure.period, 3.0);
  EXPECT_EQ(closed.closure.sign, 1.0);
}

TEST(ClosedKeys, TakeTheSignThatMakesTheLastStepTheShorter) {
  EXPECT_EQ(closed_keys(keyframes(turned({0.0, 2.0, 4.0})), Loop{4.0})->closure.sign, -1.0);
  EXPECT_EQ(closed_keys(keyframes(turned({0.0, 1.0, 2.0})), Loop{4.0})->closure.sign, 1.0);
}

TEST(ClosedKnots, WrapTheirStepsAround) {
  KeyframeData data = turned({0.0, 0.5, 1.0});
  data.times = {1.0, 2.0, 4.0};
  const Knots knots = closed_knots(keyframes(data), {.period = 7.0, .sign = 1.0});
  ASSERT_EQ(knots.segments(), 3u);
  EXPECT_EQ(knots.back(), 8.0);
  EXPECT_EQ(knots.span(0).previous_step(), 4.0);
  EXPECT_EQ(knots.span(2).next_step(), 1.0);
}

}}  // namespace orispline
