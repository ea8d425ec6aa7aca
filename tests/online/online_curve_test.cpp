// SPDX-License-Identifier: Apache-2.0
// A curve whose keys arrive one by one is, where it is final, the curve through all of them: to the last bit.
#include <orispline/online/online_curve.hpp>

#include <gtest/gtest.h>

#include <online/online_stream.hpp>
#include <orispline/families/registry.hpp>

namespace orispline {
namespace {

using namespace testing_support;

bool same(const Motion& a, const Motion& b) {
  return a.orientation.coeffs() == b.orientation.coeffs() && a.angular_velocity == b.angular_velocity &&
         a.angular_acceleration == b.angular_acceleration && a.angular_jerk == b.angular_jerk;
}
bool same(const LinearMotion& a, const LinearMotion& b) {
  return a.position == b.position && a.velocity == b.velocity && a.acceleration == b.acceleration;
}

/// How many of nine times from start to end, both included, have other bits than the offline curve.
int differing(const OnlineCurve& online, const PoseCurve& offline, double start, double end) {
  int count = 0;
  for (int k = 0; k <= 8; ++k) {
    const double t = k == 8 ? end : start + (end - start) * k / 8.0;
    const Side side = k == 8 ? Side::left : Side::right;
    const bool equal = same(online.motion(t, side), offline.orientation.motion(t, side)) &&
                       same(online.linear_motion(t, side).value(), offline.position->linear_motion(t, side)) &&
                       (k == 8 || online(t).coeffs() == offline.orientation(t).coeffs());
    count += equal ? 0 : 1;
  }
  return count;
}

class EveryOnlineMethod : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Methods, EveryOnlineMethod, testing::ValuesIn(OnlineCurve::methods()), [](const auto& test) {
  std::string name(test.param);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(EveryOnlineMethod, HasTheBitsOfTheOfflineCurveOnEverySegmentThatBecomesFinal) {
  constexpr std::size_t count = 3000;
  const KeyframeData data = raw_walk(501, count);
  const PoseCurve offline = make_pose_curve(GetParam(), keyframes(data, Signs::shortest)).value();
  OnlineCurve online = OnlineCurve::make(GetParam(), 7).value();

  int wrong = 0;
  std::size_t segments = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    if (i < 1 + online.look_ahead()) continue;
    const double end = online.available()->end;
    ASSERT_EQ(end, data.times[i - online.look_ahead()]);
    wrong += differing(online, offline, data.times[segments], end);
    ++segments;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(segments, count - 1 - online.look_ahead());

  ASSERT_TRUE(online.finish());
  EXPECT_EQ(differing(online, offline, data.times[count - 2], data.times[count - 1]), 0);
}

TEST_P(EveryOnlineMethod, KeepsTheNewestFinalKeysAndFindsEachOfTheirSegments) {
  for (const std::size_t capacity : {2u, 3u, 8u, 33u}) {
    const KeyframeData data = raw_walk(502, 100);
    const PoseCurve offline = make_pose_curve(GetParam(), keyframes(data, Signs::shortest)).value();
    OnlineCurve online = OnlineCurve::make(GetParam(), capacity).value();
    int wrong = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      ASSERT_TRUE(append(online, data, i, i + 1));
      if (i < 1 + online.look_ahead()) continue;
      const std::size_t newest = i - online.look_ahead();
      const std::size_t oldest = newest - std::min(newest, capacity - 1);
      ASSERT_EQ(online.available()->start, data.times[oldest]);
      for (std::size_t k = oldest; k < newest; ++k)
        wrong += differing(online, offline, data.times[k], data.times[k + 1]);
    }
    EXPECT_EQ(wrong, 0) << capacity;
  }
}

TEST_P(EveryOnlineMethod, UsesTheRulesOfBothEnds) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  for (const EndRule rule : family.ends)
    for (const std::size_t count : {2u, 3u, 4u, 5u, 9u}) {
      CurveOptions options{.start = {.rule = rule}, .end = {.rule = rule}};
      if (rule == EndRule::clamped) {
        options.start.angular_velocity = {0.3, -0.2, 0.7};
        options.end.angular_velocity = {-0.1, 0.4, 0.2};
      }
      const KeyframeData data = raw_walk(503, count);
      const auto offline = make_pose_curve({family.name, options}, keyframes(data, Signs::shortest));
      OnlineCurve online = OnlineCurve::make(family.name, 10, options).value();
      ASSERT_TRUE(append(online, data, 0, count));

      const auto finished = online.finish();

      ASSERT_EQ(finished.has_value(), offline.has_value()) << name_of(rule) << ", keys: " << count;
      if (!offline) {
        EXPECT_EQ(describe(finished.error()), describe(offline.error()));
        continue;
      }
      int wrong = 0;
      for (std::size_t i = 0; i + 1 < count; ++i)
        wrong += differing(online, *offline, data.times[i], data.times[i + 1]);
      EXPECT_EQ(wrong, 0) << name_of(rule) << ", keys: " << count;
      EXPECT_EQ(online.available()->end, data.times.back());
    }
}

TEST_P(EveryOnlineMethod, NeverChangesWhatIsFinal) {
  const KeyframeData data = raw_walk(504, 60);
  OnlineCurve online = OnlineCurve::make(GetParam(), 100).value();
  std::vector<std::pair<double, Motion>> seen;
  for (std::size_t i = 0; i < 60; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    const Domain domain = online.available().value();
    if (domain.start == domain.end) continue;
    const double t = 0.4 * data.times[i - online.look_ahead() - 1] + 0.6 * domain.end;
    seen.emplace_back(t, online.motion(t));
    for (const auto& [time, motion] : seen) ASSERT_TRUE(same(online.motion(time), motion)) << time;
  }
  EXPECT_EQ(seen.size(), 59 - online.look_ahead());
}

TEST(OnlineCurve, TakesParametersAndGivenSigns) {
  KeyframeData data = raw_walk(505, 50);
  for (Eigen::Quaterniond& q : data.orientations) q.normalize();
  const CurveOptions options{.parameters = {{"order", {3.0}}, {"tension1", {0.4}}, {"tension3", {0.2}}}};
  const PoseCurve offline = make_pose_curve({"uniform", options}, keyframes(data, Signs::as_given)).value();
  OnlineCurve online = OnlineCurve::make("uniform", 50, options, Signs::as_given).value();
  ASSERT_TRUE(append(online, data, 0, 50));
  ASSERT_TRUE(online.finish());
  EXPECT_EQ(differing(online, offline, data.times.front(), data.times.back()), 0);
}

TEST(OnlineCurve, IsAsSmoothInTimeAsItsFamilyAcrossEveryAppend) {
  const KeyframeData data = raw_walk(506, 500);
  OnlineCurve online = OnlineCurve::make("timed-c2", 3).value();
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
  for (std::size_t i = 0; i < 500; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    if (i < 3) continue;
    const double key = data.times[i - 2];
    const Motion left = online.motion(key, Side::left), right = online.motion(key, Side::right);
    const double scale = 1.0 + left.angular_acceleration.norm();
    velocity = std::max(velocity, (left.angular_velocity - right.angular_velocity).norm() / scale);
    acceleration = std::max(acceleration, (left.angular_acceleration - right.angular_acceleration).norm() / scale);
    jerk = std::max(jerk, (left.angular_jerk - right.angular_jerk).norm());
  }
  EXPECT_LT(velocity, 1e-12);
  EXPECT_LT(acceleration, 1e-12);
  EXPECT_GT(jerk, 1.0);
}

}  // namespace
}  // namespace orispline
