// SPDX-License-Identifier: Apache-2.0
// What a track refuses and in which words; bytes that are no state are an error, never a crash.
#include <limits>

#include <gtest/gtest.h>

#include <online/sealed_state.hpp>
#include <online/track_stream.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class T>
std::string refusal(const Expected<T>& result) {
  return result ? "taken" : describe(result.error());
}

TrackSampler fed(const Method& method, std::size_t keys, const TrackOptions& options = {}) {
  TrackSampler sampler = TrackSampler::make(method, {.step = 0.1}, options).value();
  EXPECT_TRUE(sampler.append(raw_walk(831, keys)));
  return sampler;
}

TEST(TrackSampler, RefusesOptionsWithWhatWasWanted) {
  for (const double step : {0.0, -1.0, nan, infinity})
    EXPECT_EQ(TrackSampler::make("auto", {.step = step}).error().code, ErrorCode::bad_argument);
  for (const double parts : {0.0, -1.0, nan, infinity})
    EXPECT_EQ(TrackSampler::make("auto", {.parts = parts}).error().code, ErrorCode::bad_argument);
  EXPECT_EQ(refusal(TrackSampler::make("auto", {.step = 1.0, .start = nan})),
            "the grid starts at nan s with the step 1 s, wanted finite numbers and a step greater than 0");
  EXPECT_EQ(refusal(TrackSampler::make("auto", {}, {.gap = 0.0})), "the gap is 0 s, wanted more than 0");
  EXPECT_EQ(refusal(TrackSampler::make({"timed-c2", {.loop = Loop{}}}, {})), "an online curve is open, found a loop");
  EXPECT_EQ(refusal(TrackSampler::make({"auto", {.parameters = {{"hold", {0.5}}}}}, {})),
            "auto: hold is 0.5, wanted a whole number");
  EXPECT_EQ(refusal(TrackSampler::make({"quintic", {.parameters = {{"bias", {}}}}}, {})),
            "quintic: unknown parameter 'bias', wanted one of tension");
  EXPECT_EQ(TrackSampler::make("nlerp", {}).error().code, ErrorCode::bad_argument);
}

TEST(TrackSampler, RefusesKeysInTheWordsOfKeyframesAndGoesOn) {
  KeyframeData data = raw_walk(831, 20);
  TrackSampler sampler = fed("auto", 10);
  StreamKey key = key_of(data, 10);
  key.time = data.times[9];
  EXPECT_EQ(refusal(sampler.append(key)).substr(0, 22), "key 10: duplicate time");
  key = key_of(data, 10);
  key.position.reset();
  EXPECT_EQ(refusal(sampler.append(key)), "key 10: found no position, wanted one as the keys before have");
  key = key_of(data, 10);
  key.orientation.coeffs() *= 1.01;
  EXPECT_EQ(sampler.append(key).error().where.key, 10u);
  EXPECT_EQ(sampler.keys(), 10u);
  ASSERT_TRUE(sampler.append(part_of(data, 10, 20)));
  ASSERT_TRUE(sampler.finish());
  EXPECT_EQ(refusal(sampler.append(key_of(data, 19))), "the track is finished, wanted no more keys");
  EXPECT_EQ(refusal(TrackSampler::make("auto", {}).value().finish()), "empty: no keys");

  data.orientations.pop_back();
  EXPECT_EQ(refusal(fed("auto", 3).append(data)), "found lists of different length, wanted 20 entries, one per key");
}

TEST(TrackSampler, RefusesAStretchThatIsNoCurveWhenItEnds) {
  const KeyframeData data = raw_walk(832, 9);
  TrackSampler sampler = TrackSampler::make("beta", {.step = 0.1}, {.gap = 5.0}).value();
  ASSERT_TRUE(sampler.append(part_of(data, 0, 3)));
  StreamKey late = key_of(data, 3);
  late.time += 10.0;
  EXPECT_EQ(refusal(sampler.append(late)), "beta needs 4 keys, found 3");
  ASSERT_TRUE(sampler.append(part_of(data, 3, 9)));
  EXPECT_TRUE(sampler.finish());
}

TEST(TrackSampler, GivesNoMoreSamplesThanAreReadyAndTakesNothingWhenRefused) {
  TrackSampler sampler = fed("auto", 12);
  const std::uint64_t ready = sampler.ready();
  ASSERT_GT(ready, 10u);
  TrackSamples samples;
  EXPECT_FALSE(take(sampler, samples, static_cast<std::size_t>(ready) + 1, true));
  std::vector<double> q(40), w(29);
  EXPECT_EQ(refusal(sampler.take({.orientations = q, .angular_velocities = w})),
            "found room for 29 numbers of angular velocities, wanted 30 numbers for 10 samples");
  EXPECT_EQ(refusal(sampler.take({.orientations = q}, w)), "found room for 29 times, wanted 10");
  EXPECT_EQ(sampler.ready(), ready);
  EXPECT_TRUE(sampler.take({.orientations = q}));
  EXPECT_EQ(sampler.ready(), ready - 10);
}

TEST(TrackSampler, HasOneSampleOfOneKey) {
  TrackSampler sampler = fed("auto", 1);
  EXPECT_EQ(sampler.ready(), 0u);
  ASSERT_TRUE(sampler.finish());
  EXPECT_EQ(sampler.ready(), 1u);
  TrackSamples samples;
  ASSERT_TRUE(take(sampler, samples, 1, true));
  EXPECT_EQ(samples.times[0], raw_walk(831, 1).times[0]);
}

TEST(TrackSampler, SaysAtWhichKeyOfTheTrackACurveFails) {
  KeyframeData data = raw_walk(833, 30);
  KeySettings settings{{"beta2", std::vector(30, 0.1)}};
  settings["beta2"][17] = -1000.0;
  TrackSampler sampler = TrackSampler::make({"beta", {.parameters = {{"beta2", {}}}}}, {.step = 0.1}).value();
  TrackSamples samples;
  for (std::size_t i = 0; i < 17; ++i) {
    ASSERT_TRUE(sampler.append(part_of(data, i, i + 1), {{"beta2", {settings["beta2"][i]}}}));
    ASSERT_TRUE(take(sampler, samples, static_cast<std::size_t>(sampler.ready()), true));
  }
  ASSERT_TRUE(sampler.append(part_of(data, 17, 18), {{"beta2", {-1000.0}}}));
  ASSERT_FALSE(sampler.prepare());
  EXPECT_EQ(sampler.prepare().error().where.key, 17u);
}

/// A family of one's own, with all that its data may say.
std::shared_ptr<const OwnFamily> own_family() {
  const BlendingData data{.name = "mine",
                          .title = "Typed in",
                          .parameters = {{.name = "tension", .initial = 0.5, .lowest = -2.0, .highest = 2.0}},
                          .rows = {{"1", "1+a/3", "1", "1"}, {"0", "a/3", "1-b/3", "1"}, {"0", "0", "-b/3", "0"}},
                          .first = -1,
                          .ends = "natural"};
  return BlendingFamily::make(data).value();
}

/// States of several kinds of tracks.
std::vector<std::vector<std::byte>> states() {
  std::vector<std::vector<std::byte>> all{TrackSampler::make("auto", {}).value().state(),
                                          fed("auto", 1).state(),
                                          fed("auto", 30).state(),
                                          fed("bezier", 12).state(),
                                          fed("rotation-spline", 9).state(),
                                          fed("timed-c2", 20, {.gap = 0.7}).state(),
                                          fed(own_family(), 20).state()};
  TrackSampler settings = TrackSampler::make({"tcb", {.parameters = {{"bias", {}}}}}, {}).value();
  EXPECT_TRUE(settings.append(raw_walk(834, 6), {{"bias", std::vector(6, 0.3)}}));
  all.push_back(settings.state());
  EXPECT_TRUE(settings.finish());
  all.push_back(settings.state());
  return all;
}

TEST(TrackSampler, ReadsItsOwnStateBackAsItWas) {
  for (const auto& state : states()) EXPECT_EQ(TrackSampler::from_state(state).value().state(), state);
}

TEST(TrackSampler, RefusesStatesThatAreCutOrChanged) {
  for (const auto& state : states()) {
    for (std::size_t size = 0; size < state.size(); ++size)
      EXPECT_EQ(TrackSampler::from_state(std::span(state).first(size)).error().code, ErrorCode::bad_data);
    for (std::size_t at = 0; at < state.size(); ++at) {
      auto changed = state;
      changed[at] ^= std::byte{0x10};
      EXPECT_EQ(TrackSampler::from_state(changed).error().code, ErrorCode::bad_data);
    }
  }
}

TEST(TrackSampler, LivesWithStatesThatAreForged) {
  // With the right checksum a change may make another state that is sound, or none; whichever, it may be used.
  Dice dice(835);
  for (const auto& state : states())
    for (int k = 0; k < 3000; ++k) {
      StateBytes forged = unsealed(state);
      for (int changes = 1 + static_cast<int>(dice() * 3.0); changes > 0; --changes)
        forged[static_cast<std::size_t>(dice() * static_cast<double>(forged.size()))] =
            static_cast<std::byte>(dice() * 256.0);
      auto sampler = TrackSampler::from_state(sealed(std::move(forged)));
      if (!sampler) {
        EXPECT_EQ(sampler.error().code, ErrorCode::bad_data);
        continue;
      }
      std::vector<double> q(4 * static_cast<std::size_t>(std::min<std::uint64_t>(sampler->ready(), 100)));
      const auto taken = sampler->take({.orientations = q});
      const auto finished = sampler->finish();
      q.resize(4 * static_cast<std::size_t>(std::min<std::uint64_t>(sampler->ready(), 100)));
      const auto more = sampler->take({.orientations = q});
      EXPECT_TRUE(taken.has_value() || finished.has_value() || !more.has_value());
    }
}

}}  // namespace orispline
