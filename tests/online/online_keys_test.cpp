// SPDX-License-Identifier: Apache-2.0
// What an online curve refuses and in which words, and what it answers where there is nothing final.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <online/online_stream.hpp>
#include <orispline/base/formatted.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

const Eigen::Quaterniond one = Eigen::Quaterniond::Identity();

OnlineCurve timed(std::size_t capacity = 8) { return OnlineCurve::make("timed-c2", capacity).value(); }

std::string refusal(const Expected<OnlineCurve>& made) { return made ? "made" : describe(made.error()); }
std::string refusal(const Expected<void>& taken) { return taken ? "taken" : describe(taken.error()); }

std::string names_of_local_families() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info())
    if (!family.is_global()) names.push_back(family.name);
  return joined(names, ", ");
}

TEST(OnlineCurve, RefusesOptionsWithWhatWasWanted) {
  EXPECT_EQ(refusal(OnlineCurve::make("nu", 8)),
            "method 'nu' has no online curve, wanted one of " + names_of_local_families());
  EXPECT_EQ(refusal(OnlineCurve::make({"beta-g2", {.choices = {{"form", "global"}}}}, 8)),
            "beta-g2: with these settings a segment depends on all keys, wanted others for an online curve");
  EXPECT_EQ(refusal(OnlineCurve::make("slerp", 1)), "the capacity is 1 keys, wanted 2 to 1000000");
  EXPECT_EQ(refusal(OnlineCurve::make("slerp", 1'000'001)), "the capacity is 1000001 keys, wanted 2 to 1000000");
  EXPECT_EQ(refusal(OnlineCurve::make({"quintic", {.loop = Loop{}}}, 8)), "an online curve is open, found a loop");
  EXPECT_EQ(
      refusal(OnlineCurve::make({"quintic", {.parameters = {{"tension", {0.5, 0.5, 0.5, 0.5}}}}}, 8)),
      "quintic: found 4 values of tension, wanted 1 for all keys of an online curve, or none where each key brings "
      "its own");
  EXPECT_EQ(refusal(OnlineCurve::make({"quintic", {.parameters = {{"tension", {nan}}}}}, 8)),
            "quintic: tension is nan, wanted -100 to 100");
  EXPECT_EQ(refusal(OnlineCurve::make({"uniform", {.parameters = {{"order", {2.5}}}}}, 8)),
            "uniform: order is 2.5, wanted a whole number");
}

TEST(OnlineCurve, RefusesEndsThatNoKeysCanHaveBeforeThereAreAny) {
  const End turning{.rule = EndRule::clamped, .angular_velocity = {0, 0, 1}};
  const std::string wanted = "a clamped end needs a non-zero tension at that key, found 0";
  EXPECT_EQ(refusal(OnlineCurve::make({"quintic", {.parameters = {{"tension", {0.0}}}, .start = turning}}, 8)), wanted);
  EXPECT_EQ(refusal(OnlineCurve::make({"quintic", {.parameters = {{"tension", {0.0}}}, .end = turning}}, 8)), wanted);
}

TEST(OnlineCurve, RefusesKeysInTheWordsOfKeyframesAndGoesOn) {
  struct Bad {
    double time;
    Eigen::Quaterniond orientation;
  };
  const KeyframeData good = raw_walk(701, 12);
  for (const Bad& bad :
       {Bad{nan, one}, Bad{good.times[4], one}, Bad{good.times[3], one}, Bad{1e300, one}, Bad{1e16, one},
        Bad{1e9, Eigen::Quaterniond(nan, 0, 0, 0)}, Bad{1e9, Eigen::Quaterniond(1.01, 0, 0, 0)}}) {
    OnlineCurve curve = timed(), undisturbed = timed();
    KeyframeData data{.times = good.times, .orientations = good.orientations};
    ASSERT_TRUE(append(curve, data, 0, 5));
    ASSERT_TRUE(append(undisturbed, data, 0, 12));
    KeyframeData spoilt = data;
    spoilt.times.resize(5);
    spoilt.orientations.resize(5);
    spoilt.times.push_back(bad.time);
    spoilt.orientations.push_back(bad.orientation);

    EXPECT_EQ(refusal(curve.append(bad.time, bad.orientation)), describe(Keyframes::make(spoilt).error()));

    EXPECT_EQ(curve.keys(), 5u);
    ASSERT_TRUE(append(curve, data, 5, 12));
    const double t = curve.available()->end - 0.01;
    EXPECT_EQ(curve(t).coeffs(), undisturbed(t).coeffs());
  }
}

TEST(OnlineCurve, RefusesStepsTooUnevenAmongTheKeysSeenTogetherOnly) {
  for (std::size_t between = 0; between <= 6; ++between) {
    OnlineCurve curve = OnlineCurve::make("auto", 8).value();
    ASSERT_TRUE(curve.append(0.0, one));
    ASSERT_TRUE(curve.append(1e-9, one));
    for (std::size_t i = 1; i <= between; ++i) ASSERT_TRUE(curve.append(static_cast<double>(i), one));
    const auto taken = curve.append(2e5, one);
    EXPECT_EQ(taken.has_value(), between >= 5) << between;
    if (!taken) {
      EXPECT_NE(taken.error().message.find("among the 5 before it"), std::string::npos) << taken.error().message;
    }
    EXPECT_TRUE(curve.append(3e5, one) || between < 5);
  }
}

TEST(OnlineCurve, WantsPositionsAtAllKeysOrAtNone) {
  OnlineCurve with = timed(), without = timed();
  ASSERT_TRUE(with.append(0.0, one, {1, 2, 3}));
  ASSERT_TRUE(without.append(0.0, one));
  EXPECT_EQ(refusal(with.append(1.0, one)), "key 1: found no position, wanted one as the keys before have");
  EXPECT_EQ(refusal(without.append(1.0, one, {0, 0, 0})),
            "key 1: found a position, wanted none as the keys before have none");
  EXPECT_EQ(refusal(with.append(1.0, one, {0, nan, 0})),
            "key 1: the position has a component that is not finite, wanted finite numbers");
  EXPECT_EQ(with.linear_motion(0.0)->position, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(without.linear_motion(0.0));
}

void expect_nothing_known(const Motion& motion) {
  EXPECT_TRUE(motion.orientation.coeffs().array().isNaN().all());
  for (const Eigen::Vector3d& rate : {motion.angular_velocity, motion.angular_acceleration, motion.angular_jerk})
    EXPECT_TRUE(rate.array().isNaN().all());
}

void expect_nothing_known(const LinearMotion& motion) {
  for (const Eigen::Vector3d& rate : {motion.position, motion.velocity, motion.acceleration, motion.jerk})
    EXPECT_TRUE(rate.array().isNaN().all());
}

TEST(OnlineCurve, HoldsTheFirstKeyUntilASegmentIsFinal) {
  OnlineCurve curve = timed();
  EXPECT_FALSE(curve.available());
  expect_nothing_known(curve.motion(0.0));
  EXPECT_TRUE(std::isnan(curve(0.0).w()));
  EXPECT_EQ(describe(curve.checked_motion(0.0).error()), "the curve has no keys, wanted at least one");
  EXPECT_EQ(refusal(curve.finish()), "empty: no keys");

  const KeyframeData data = raw_walk(702, 3);
  const Eigen::Quaterniond first = Keyframes::make(data).value().orientations()[0];
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(append(curve, data, i, i + 1));
    EXPECT_EQ(curve.available()->start, data.times[0]);
    EXPECT_EQ(curve.available()->end, data.times[0]);
    EXPECT_EQ(curve(5.0).coeffs(), first.coeffs());
    EXPECT_TRUE(std::isnan(curve(nan).w()));
    expect_nothing_known(curve.motion(nan));
    expect_nothing_known(*curve.linear_motion(nan));
    EXPECT_EQ(curve.motion(5.0).angular_velocity, Eigen::Vector3d::Zero());
    EXPECT_EQ(curve.linear_motion(5.0)->position, data.positions[0]);
  }
  ASSERT_TRUE(append(curve, data, 2, 3));
  EXPECT_EQ(curve.available()->end, data.times[1]);
}

TEST(OnlineCurve, HoldsAtRestOutsideWhatIsAvailableOrSaysSo) {
  const KeyframeData data = raw_walk(703, 20);
  OnlineCurve curve = timed(5);
  ASSERT_TRUE(append(curve, data, 0, 20));
  const auto [start, end] = curve.available().value();
  EXPECT_EQ(start, data.times[14]);
  EXPECT_EQ(end, data.times[18]);
  for (const auto& [t, held] : {std::pair(start - 1e-9, start), std::pair(end + 1e-9, end), std::pair(1e9, end)}) {
    EXPECT_EQ(curve(t).coeffs(), curve(held).coeffs());
    EXPECT_EQ(curve.motion(t).orientation.coeffs(), curve(held).coeffs());
    EXPECT_EQ(curve.motion(t).angular_velocity, Eigen::Vector3d::Zero());
    EXPECT_EQ(curve.linear_motion(t)->position, curve.linear_motion(held)->position);
    EXPECT_EQ(curve.linear_motion(t)->velocity, Eigen::Vector3d::Zero());
    EXPECT_FALSE(curve.checked_motion(t));
  }
  EXPECT_GT(curve.motion(end).angular_velocity.norm(), 0.0);
  EXPECT_GT(curve.checked_motion(end).value().angular_velocity.norm(), 0.0);
  EXPECT_TRUE(std::isnan(curve(nan).w()));
  expect_nothing_known(curve.motion(nan));
  expect_nothing_known(*curve.linear_motion(nan));
  EXPECT_FALSE(curve.checked_motion(nan));
}

TEST(OnlineCurve, CountsNoKeyThatItRefusesForTheGhostOfTheFirst) {
  const End turning{.rule = EndRule::clamped, .angular_velocity = {0, 0, 1}};
  OnlineCurve curve = OnlineCurve::make({"timed-c2", {.parameters = {{"tension", {}}}, .start = turning}}, 8).value();
  const auto key = [](double time) {
    return StreamKey{.time = time, .orientation = one, .settings = {{"tension", 0.0}}};
  };
  std::uint64_t taken = 0;
  while (curve.append(key(static_cast<double>(taken)))) ASSERT_LT(++taken, 8u);
  for (int again = 0; again < 3; ++again) {
    EXPECT_EQ(curve.keys(), taken);
    EXPECT_EQ(refusal(curve.append(key(static_cast<double>(taken)))),
              "key 0: a clamped end needs a non-zero tension at that key, found 0");
  }
  EXPECT_EQ(curve.keys(), taken);
  EXPECT_EQ(refusal(curve.append(key(nan))), formatted("key {}: time is nan, wanted a finite number", taken));
}

TEST(OnlineCurve, EndsOnceAndBeginsAnewAfterReset) {
  const KeyframeData data = raw_walk(704, 10);
  OnlineCurve curve = timed(4), fresh = timed(4);
  ASSERT_TRUE(append(curve, data, 0, 10));
  ASSERT_TRUE(curve.finish());
  EXPECT_EQ(refusal(curve.append(1e6, one, {0, 0, 0})),
            "the curve is finished, wanted no more keys; reset() begins a new curve");
  EXPECT_TRUE(curve.finish());

  curve.reset();

  EXPECT_FALSE(curve.available());
  KeyframeData other = raw_walk(705, 6);
  other.positions.clear();
  ASSERT_TRUE(append(curve, other, 0, 6));
  ASSERT_TRUE(append(fresh, other, 0, 6));
  const double t = 0.3 * curve.available()->start + 0.7 * curve.available()->end;
  EXPECT_EQ(curve(t).coeffs(), fresh(t).coeffs());
  EXPECT_EQ(curve.keys(), 6u);
}

}}  // namespace orispline
