// SPDX-License-Identifier: Apache-2.0
// However the keys of a track are cut into pieces, and through any number of states, its samples are those of the curve
// through all of them: to the last bit.
#include <orispline/online/track_sampler.hpp>

#include <gtest/gtest.h>

#include <online/track_stream.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <support/inner_quaternions.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr double track_step = 0.037;  // [s]: some ten samples between two keys, or none

class EveryMethodOfTracks : public testing::TestWithParam<FamilyInfo> {
 protected:
  /// Keys as many as the method takes, as wide as it takes.
  [[nodiscard]] static KeyframeData walk(std::uint64_t seed, std::size_t count) {
    KeyframeData data =
        posed_walk(seed, GetParam().key_use.cut(count), Spacing::uneven, std::min(1.5, GetParam().key_use.widest_turn));
    Dice dice(seed + 2);
    for (Eigen::Quaterniond& q : data.orientations)
      q.coeffs() *= (dice() < 0.5 ? -1.0 : 1.0) * dice.between(0.9995, 1.0005);
    return data;
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethodOfTracks, testing::ValuesIn(families_info()), [](const auto& test) {
  std::string name(test.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(EveryMethodOfTracks, HasTheSamplesOfTheWholeCurveHoweverItsKeysAreCut) {
  const std::size_t count = GetParam().is_global() ? 24 : 150;
  for (const std::uint64_t seed : {801u, 802u, 803u}) {
    const KeyframeData data = walk(seed, count);
    const PoseCurve whole = make_pose_curve(GetParam().name, keyframes(data, Signs::shortest)).value();
    const TrackSamples wanted = of_whole(whole, whole.orientation.domain().start, track_step);
    for (const std::uint64_t cuts : {1u, 2u, 3u})
      EXPECT_TRUE(streamed(TrackSampler::make(GetParam().name, {.step = track_step}).value(), data, {},
                           seed + 100 * cuts) == wanted)
          << seed << ", cuts " << cuts;
  }
}

TEST(TrackSampler, HasTheSamplesOfTheWholeCurveOfBlendingFunctionsOfOnesOwn) {
  const std::vector<std::string> done{"1", "9/10", "1"}, own{"0", "2/5", "1"}, begun{"0", "1/10", "0"};
  const std::vector<BlendingData> families{
      {.name = "one", .title = "", .rows = {own}},
      {.name = "two-behind", .title = "", .rows = {own, begun}, .first = 0},
      {.name = "two-before", .title = "", .rows = {done, own}, .first = -1},
      {.name = "three", .title = "", .rows = {done, own, begun}},
      {.name = "five", .title = "", .rows = {done, done, own, begun, begun}},
  };
  const KeyframeData data = posed_walk(805, 60, Spacing::uneven, 1.0);
  for (const BlendingData& stated : families) {
    const Method method(BlendingFamily::make(stated).value());
    const PoseCurve whole = make_pose_curve(method, keyframes(data, Signs::shortest)).value();
    const TrackSamples wanted = of_whole(whole, whole.orientation.domain().start, track_step);
    for (const std::uint64_t cuts : {1u, 2u, 3u})
      EXPECT_TRUE(streamed(TrackSampler::make(method, {.step = track_step}).value(), data, {}, cuts) == wanted)
          << stated.name << ", cuts " << cuts;
  }
}

TEST_P(EveryMethodOfTracks, HasTheSamplesOfTheWholeCurveHoweverFewItsKeysAreAndWhateverItsEnds) {
  std::vector<EndRule> rules(GetParam().ends.begin(), GetParam().ends.end());
  if (rules.empty()) rules.push_back(EndRule::none);
  for (const EndRule rule : rules)
    for (std::size_t count = 1; count <= 12; ++count) {
      const CurveOptions options{.start = {.rule = rule}, .end = {.rule = rule}};
      KeyframeData data = walk(804, 20);
      data = part_of(data, 0, count);
      const auto whole = make_pose_curve({GetParam().name, options}, keyframes(data, Signs::shortest));
      TrackSampler sampler = TrackSampler::make({GetParam().name, options}, {.step = track_step}).value();
      if (whole) {
        EXPECT_TRUE(streamed(sampler, data, {}, count) ==
                    of_whole(*whole, whole->orientation.domain().start, track_step))
            << name_of(rule) << ", keys: " << count;
        continue;
      }
      ASSERT_TRUE(sampler.append(data));
      const auto done = sampler.finish().and_then([&] { return sampler.prepare(); });
      ASSERT_FALSE(done) << name_of(rule) << ", keys: " << count;
      EXPECT_EQ(describe(done.error()), describe(whole.error()));
    }
}

TEST_P(EveryMethodOfTracks, TakesParametersThatComeWithTheKeys) {
  const KeyframeData data = walk(805, 40);
  Dice dice(806);
  CurveOptions options, of_stream;
  KeySettings settings;
  for (const Parameter& parameter : GetParam().parameters) {
    if (!parameter.per_key) continue;
    const std::string name(parameter.name);
    for (std::size_t i = 0; i < data.times.size(); ++i)
      settings[name].push_back(parameter.initial + dice.between(0.05, 0.4));
    options.parameters[name] = settings[name];
    of_stream.parameters[name] = {};
  }
  const auto whole = make_pose_curve({GetParam().name, options}, keyframes(data, Signs::shortest));
  ASSERT_TRUE(whole) << describe(whole.error());
  const TrackSampler sampler = TrackSampler::make({GetParam().name, of_stream}, {.step = track_step}).value();
  EXPECT_TRUE(streamed(sampler, data, settings, 807) ==
              of_whole(*whole, whole->orientation.domain().start, track_step));
}

TEST_P(EveryMethodOfTracks, ForgetsTheKeysThatNoSampleNeedsAnyMore) {
  if (GetParam().is_global()) return;
  const KeyframeData data = walk(808, 400);
  for (const double sparse_or_dense : {0.01, 30.0}) {
    TrackSampler sampler = TrackSampler::make(GetParam().name, {.step = sparse_or_dense}).value();
    TrackSamples samples;
    std::size_t most = 0;
    for (std::size_t i = 0; i < data.times.size(); ++i) {
      ASSERT_TRUE(sampler.append(key_of(data, i)));
      ASSERT_TRUE(take(sampler, samples, static_cast<std::size_t>(sampler.ready()), true));
      most = std::max(most, sampler.kept());
    }
    EXPECT_LE(most, 16u) << sparse_or_dense;
    EXPECT_LT(sampler.state().size(), 2500u);
  }
}

TEST(TrackSampler, HoldsEqualKeysAtRest) {
  KeyframeData data = raw_walk(811, 60);
  for (const std::size_t i : {1u, 9u, 10u, 21u, 33u, 59u}) data.orientations[i] = data.orientations[i - 1];
  const CurveOptions options{.parameters = {{"hold", {1.0}}}};
  for (const std::string_view method : {"auto", "auto5"}) {
    const PoseCurve whole = make_pose_curve({method, options}, keyframes(data, Signs::shortest)).value();
    const TrackSampler sampler = TrackSampler::make({method, options}, {.step = track_step}).value();
    EXPECT_TRUE(streamed(sampler, data, {}, 812) == of_whole(whole, data.times.front(), track_step)) << method;
  }
}

TEST(TrackSampler, TakesSettingsOnWhichTheKeysOfASegmentDepend) {
  const KeyframeData data = raw_walk(813, 60);
  std::vector<std::pair<std::string_view, CurveOptions>> curves{{"beta-g2", {.choices = {{"form", "global"}}}},
                                                                {"hermite-c3", {.choices = {{"stencil", "3"}}}},
                                                                {"family", {.parameters = {{"order", {4.0}}}}}};
  for (const double degree : {2.0, 3.0, 4.0, 5.0})
    curves.push_back({"bspline", {.parameters = {{"degree", {degree}}}}});
  for (const auto& [method, options] : curves) {
    const PoseCurve whole = make_pose_curve({method, options}, keyframes(data, Signs::shortest)).value();
    const TrackSampler sampler = TrackSampler::make({method, options}, {.step = track_step}).value();
    EXPECT_TRUE(streamed(sampler, data, {}, 814) == of_whole(whole, whole.orientation.domain().start, track_step))
        << method;
  }
}

TEST(TrackSampler, TakesRatesOfTheKeysAndSignsAsGiven) {
  KeyframeData data = raw_walk(815, 60);
  data.positions.clear();
  Dice dice(816);
  for (std::size_t i = 0; i < 60; ++i) {
    data.angular_velocities.push_back(dice.vector());
    data.angular_accelerations.push_back(dice.vector());
  }
  for (const std::string_view method : {"hermite-c2", "hermite-cumulative", "auto"}) {
    const PoseCurve whole = make_pose_curve(method, keyframes(data, Signs::as_given)).value();
    const TrackSampler sampler = TrackSampler::make(method, {.step = track_step}, {.signs = Signs::as_given}).value();
    EXPECT_TRUE(streamed(sampler, data, {}, 817) == of_whole(whole, data.times.front(), track_step)) << method;
  }
}

TEST(TrackSampler, TakesInnerQuaternionsOfTheKeys) {
  KeyframeData data = with_inner_quaternions(raw_walk(822, 60), 823);
  data.inner_leaving[7] = data.inner_arriving[9] = free_inner();
  const PoseCurve whole = make_pose_curve("squad", keyframes(data, Signs::shortest)).value();
  const TrackSampler sampler = TrackSampler::make("squad", {.step = track_step}).value();
  EXPECT_TRUE(streamed(sampler, data, {}, 824) == of_whole(whole, data.times.front(), track_step));
}

TEST(TrackSampler, SamplesOnAGridThatStartsElsewhere) {
  const KeyframeData data = raw_walk(818, 50);
  const PoseCurve whole = make_pose_curve("auto", keyframes(data, Signs::shortest)).value();
  for (const double start : {data.times.front() - 2.0, data.times[10] + 0.01, data.times.back() + 1.0}) {
    const TrackSampler sampler = TrackSampler::make("auto", {.step = track_step, .start = start}).value();
    EXPECT_TRUE(streamed(sampler, data, {}, 819) == of_whole(whole, start, track_step)) << start;
  }
}

TEST(TrackSampler, SamplesAtTimesThatAreRoundedOnce) {
  const KeyframeData data = raw_walk(818, 50);
  const PoseCurve whole = make_pose_curve("auto", keyframes(data, Signs::shortest)).value();
  const TrackSampler sampler = TrackSampler::make("auto", {.step = 1001.0, .parts = 30000.0, .start = 0.0}).value();
  const TrackSamples samples = streamed(sampler, data, {}, 819);
  EXPECT_TRUE(samples == of_whole(whole, 0.0, 1001.0, 30000.0));
  const double first = std::round(samples.times[0] * 30000.0 / 1001.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(samples.times[i], (first + static_cast<double>(i)) * 1001.0 / 30000.0);
}

TEST(TrackSampler, BeginsANewCurveAfterAGap) {
  KeyframeData data = raw_walk(820, 60);
  const std::vector<std::size_t> ends{0, 13, 14, 37, 60};
  double pause = 0.0;
  for (std::size_t i = 0; i < 60; ++i) {
    if (std::ranges::find(ends, i) != ends.end() && i > 0) pause += 7.3;
    data.times[i] += pause;
  }
  for (const std::string_view method : {"slerp", "auto", "timed-c2", "rotation-spline"}) {
    TrackSamples wanted;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const auto part = keyframes(part_of(data, ends[k], ends[k + 1]), Signs::shortest);
      const TrackSamples more = of_whole(make_pose_curve(method, part).value(), data.times.front(), track_step);
      const auto behind = [](std::vector<double>& list, const std::vector<double>& other) {
        list.insert(list.end(), other.begin(), other.end());
      };
      behind(wanted.times, more.times);
      behind(wanted.orientations, more.orientations);
      behind(wanted.angular_velocities, more.angular_velocities);
      behind(wanted.angular_accelerations, more.angular_accelerations);
      behind(wanted.angular_jerks, more.angular_jerks);
      behind(wanted.positions, more.positions);
      behind(wanted.velocities, more.velocities);
      behind(wanted.accelerations, more.accelerations);
    }
    for (const std::uint64_t cuts : {1u, 2u, 3u, 4u}) {
      const TrackSampler sampler = TrackSampler::make(method, {.step = track_step}, {.gap = 5.0}).value();
      EXPECT_TRUE(streamed(sampler, data, {}, 821 + cuts) == wanted) << method;
    }
  }
}

}}  // namespace orispline
