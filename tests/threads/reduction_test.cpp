// SPDX-License-Identifier: Apache-2.0
// Recordings that are reduced on many threads have the keys that one finds.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/reduce/reduce.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(ReduceTracks, FindsTheSameKeysOnManyThreads) {
  std::vector<Track> tracks;
  for (std::uint64_t seed = 431; seed < 441; ++seed) {
    const AnyCurve curve = make_curve("auto", keyframes(random_walk(seed, 8, Spacing::uneven, 0.7))).value();
    KeyframeData samples;
    for (const double t : sample_times(curve.knots().times(), 10)) {
      samples.times.push_back(t);
      samples.orientations.push_back(curve(t));
    }
    tracks.push_back(keyframes(std::move(samples)));
  }
  const std::vector<Method> methods(reducing_methods.begin(), reducing_methods.end());
  const ReduceOptions options{.tolerance = {.angle = 0.01}, .values = KeyValues::refitted};
  const auto alone = reduce_tracks(tracks, methods, options, 1), many = reduce_tracks(tracks, methods, options, 8);
  ASSERT_EQ(many.size(), tracks.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    ASSERT_TRUE(alone[i] && many[i]);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      EXPECT_EQ(alone[i]->at(m).samples, many[i]->at(m).samples);
      EXPECT_EQ(alone[i]->at(m).deviation.angle, many[i]->at(m).deviation.angle);
    }
  }
}

}}  // namespace orispline
