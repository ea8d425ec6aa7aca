// SPDX-License-Identifier: Apache-2.0
// Which keys are compared with what.
#include <gtest/gtest.h>

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { namespace {

/// A steady turn, from an epoch [s], at these times behind it [s].
Track turn(const Decimal& epoch, std::vector<double> times) {
  KeyframeData data{.times = std::move(times)};
  for (const double t : data.times) data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, 0.1 * t)));
  Track track(Keyframes::make(std::move(data)).value());
  track.epoch = epoch;
  track.name = "turn.csv";
  return track;
}

Track turn_of(std::size_t samples) {
  std::vector<double> times(samples);
  for (std::size_t i = 0; i < samples; ++i) times[i] = static_cast<double>(i);
  return turn(Decimal(), times);
}

TEST(ComparedKeys, AreSomeOfTheSamples) {
  const auto data = beside_own_samples(turn_of(10), std::vector<Decimation>{{.keep_every = 4}, {.keep_every = 9}});
  ASSERT_TRUE(data);
  ASSERT_EQ(data->key_sets.size(), 2u);
  EXPECT_EQ(data->times.size(), 10u);
  const auto times = data->key_sets[0].track.keys.times();
  EXPECT_EQ(std::vector(times.begin(), times.end()), (std::vector{0.0, 4.0, 8.0}));
  EXPECT_EQ(data->key_sets[0].compared, 9u);  // the sample behind the last key counts no more
  EXPECT_EQ(data->key_sets[1].compared, 10u);
  EXPECT_EQ(data->key_sets[1].decimation->keep_every, 9u);
}

TEST(ComparedKeys, AreTwoAtLeast) {
  const auto data = beside_own_samples(turn_of(5), std::vector<Decimation>{{.keep_every = 5}});
  ASSERT_FALSE(data);
  EXPECT_EQ(describe(data.error()), "turn.csv: `keep_every` 5 leaves 1 of the 5 samples, wanted 2 keys at least");
  EXPECT_FALSE(beside_own_samples(turn_of(1), {}));
}

TEST(ComparedKeys, LieBesideARecordingOfAnotherEpoch) {
  const Track keys = turn(Decimal(), {100.0, 102.0, 104.0});
  const Track recording = turn(Decimal::parse("99").value(), {0.0, 1.0, 1.5, 3.0, 5.0, 7.0});
  const auto data = beside_recording(keys, recording);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->times, (std::vector{99.0, 100.0, 100.5, 102.0, 104.0, 106.0}));
  ASSERT_EQ(data->key_sets.size(), 1u);
  EXPECT_EQ(data->key_sets[0].compared, 4u);
  EXPECT_FALSE(data->key_sets[0].decimation);
  EXPECT_TRUE(data->warnings.empty());
}

TEST(ComparedKeys, AreWarnedOfWhereTheRecordingIsNoDenser) {
  const Track keys = turn(Decimal(), {0.0, 1.0, 2.0});
  const auto data = beside_recording(keys, turn(Decimal(), {0.0, 2.0}));
  ASSERT_TRUE(data);
  ASSERT_EQ(data->warnings.size(), 1u);
  EXPECT_EQ(data->warnings[0].code, "no_reference_between_keys");
  const auto apart = beside_recording(keys, turn(Decimal(), {5.0, 6.0}));
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().message, "none of the 2 times, 5 to 6 s, lies between the keys of turn.csv, 0 to 2 s");
}

}}  // namespace orispline
