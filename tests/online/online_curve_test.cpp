// SPDX-License-Identifier: Apache-2.0
// A curve whose keys arrive one by one is, where it is final, the curve through all of them: to the last bit.
#include <orispline/online/online_curve.hpp>

#include <gtest/gtest.h>

#include <online/online_stream.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { namespace {

using namespace testing_support;

bool same(const Motion& a, const Motion& b) {
  return a.orientation.coeffs() == b.orientation.coeffs() && a.angular_velocity == b.angular_velocity &&
         a.angular_acceleration == b.angular_acceleration && a.angular_jerk == b.angular_jerk;
}
bool same(const LinearMotion& a, const LinearMotion& b) {
  return a.position == b.position && a.velocity == b.velocity && a.acceleration == b.acceleration && a.jerk == b.jerk;
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
  OnlineCurve online = OnlineCurve::make(GetParam(), 7).value();
  const FinalKeys final_keys(GetParam(), online);
  const std::size_t count = final_keys.use.cut(3000);
  const KeyframeData data = raw_walk(501, count);
  const PoseCurve offline = make_pose_curve(GetParam(), keyframes(data, Signs::shortest)).value();

  int wrong = 0;
  std::size_t segments = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    for (; segments < final_keys.segments(i + 1); ++segments)
      wrong += differing(online, offline, data.times[final_keys.start(segments)],
                         data.times[final_keys.start(segments + 1)]);
    if (segments > 0) {
      ASSERT_EQ(online.available()->end, data.times[final_keys.start(segments)]);
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(segments, (count - 1 - final_keys.use.first - online.look_ahead()) / final_keys.use.stride);

  ASSERT_TRUE(online.finish());
  const std::size_t last = count - 1 - final_keys.use.first;
  EXPECT_EQ(online.available()->end, data.times[last]);
  for (; final_keys.start(segments) < last; ++segments)
    wrong +=
        differing(online, offline, data.times[final_keys.start(segments)], data.times[final_keys.start(segments + 1)]);
  EXPECT_EQ(wrong, 0);
}

TEST_P(EveryOnlineMethod, KeepsTheNewestFinalKeysAndFindsEachOfTheirSegments) {
  const KeyframeData data = raw_walk(502, 100);
  const PoseCurve offline = make_pose_curve(GetParam(), keyframes(data, Signs::shortest)).value();
  for (const std::size_t capacity : {2u, 3u, 8u, 33u}) {
    OnlineCurve online = OnlineCurve::make(GetParam(), capacity).value();
    const FinalKeys final_keys(GetParam(), online);
    int wrong = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      ASSERT_TRUE(append(online, data, i, i + 1));
      const std::size_t segments = final_keys.segments(i + 1);
      if (segments == 0) continue;
      const std::size_t oldest = segments - std::min(segments, capacity - 1);
      ASSERT_EQ(online.available()->start, data.times[final_keys.start(oldest)]);
      for (std::size_t k = oldest; k < segments; ++k)
        wrong += differing(online, offline, data.times[final_keys.start(k)], data.times[final_keys.start(k + 1)]);
    }
    EXPECT_EQ(wrong, 0) << capacity;
  }
}

TEST_P(EveryOnlineMethod, UsesTheRulesOfBothEnds) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  std::vector<EndRule> rules(family.ends.begin(), family.ends.end());
  if (rules.empty()) rules.push_back(EndRule::none);
  for (const EndRule rule : rules)
    for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u}) {
      CurveOptions options{.start = {.rule = rule}, .end = {.rule = rule}};
      if (rule == EndRule::clamped) {
        options.start.angular_velocity = {0.3, -0.2, 0.7};
        options.end.angular_velocity = {-0.1, 0.4, 0.2};
      }
      const KeyframeData data = raw_walk(503, count);
      const auto offline = make_pose_curve({family.name, options}, keyframes(data, Signs::shortest));
      OnlineCurve online = OnlineCurve::make({family.name, options}, 10).value();
      ASSERT_TRUE(append(online, data, 0, count));

      const auto finished = online.finish();

      ASSERT_EQ(finished.has_value(), offline.has_value()) << name_of(rule) << ", keys: " << count;
      if (!offline) {
        EXPECT_EQ(describe(finished.error()), describe(offline.error()));
        continue;
      }
      int wrong = 0;
      const Domain domain = offline->orientation.domain();
      for (std::size_t i = 0; i + 1 < count; ++i)
        if (domain.start <= data.times[i] && data.times[i + 1] <= domain.end)
          wrong += differing(online, *offline, data.times[i], data.times[i + 1]);
      EXPECT_EQ(wrong, 0) << name_of(rule) << ", keys: " << count;
      EXPECT_EQ(online.available()->end, domain.end);
    }
}

TEST_P(EveryOnlineMethod, NeverChangesWhatIsFinal) {
  const KeyframeData data = raw_walk(504, 60);
  OnlineCurve online = OnlineCurve::make(GetParam(), 100).value();
  const FinalKeys final_keys(GetParam(), online);
  std::vector<std::pair<double, Motion>> seen;
  for (std::size_t i = 0; i < 60; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    for (std::size_t segment = seen.size(); segment < final_keys.segments(i + 1); ++segment) {
      const double t = 0.4 * data.times[final_keys.start(segment)] + 0.6 * data.times[final_keys.start(segment + 1)];
      seen.emplace_back(t, online.motion(t));
    }
    for (const auto& [time, motion] : seen) ASSERT_TRUE(same(online.motion(time), motion)) << time;
  }
  EXPECT_EQ(seen.size(), final_keys.segments(60));
}

TEST(OnlineCurve, TakesParametersAndGivenSigns) {
  KeyframeData data = raw_walk(505, 50);
  for (Eigen::Quaterniond& q : data.orientations) q.normalize();
  const CurveOptions options{.parameters = {{"order", {3.0}}, {"tension1", {0.4}}, {"tension3", {0.2}}}};
  const PoseCurve offline = make_pose_curve({"uniform", options}, keyframes(data, Signs::as_given)).value();
  OnlineCurve online = OnlineCurve::make({"uniform", options}, 50, Signs::as_given).value();
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

}}  // namespace orispline
