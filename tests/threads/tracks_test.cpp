// SPDX-License-Identifier: Apache-2.0
// Tracks that are sampled on many threads, some of them bad.
#include <gtest/gtest.h>

#include <orispline/online/sample_tracks.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Many tracks in one memory, every seventh with a time that does not rise.
struct Herd {
  std::vector<std::int64_t> offsets{0};
  std::vector<double> times;
  std::array<std::vector<double>, 4> orientations;

  explicit Herd(std::size_t tracks) {
    for (std::size_t i = 0; i < tracks; ++i) {
      KeyframeData track = random_walk(500 + i, 2 + i % 90, Spacing::uneven, 0.8);
      if (i % 7 == 6) track.times.back() = track.times.front();
      times.insert(times.end(), track.times.begin(), track.times.end());
      for (const Eigen::Quaterniond& q : track.orientations)
        for (std::size_t c = 0; c < 4; ++c) orientations[c].push_back(q.coeffs()[static_cast<Eigen::Index>(c)]);
      offsets.push_back(static_cast<std::int64_t>(times.size()));
    }
  }
  [[nodiscard]] SampledTracks sampled(unsigned threads) const {
    const TrackColumns columns{.offsets = offsets,
                               .times = times,
                               .orientations = {orientations[0], orientations[1], orientations[2], orientations[3]}};
    return sample_tracks("auto", columns, {.step = 0.01}, {.angular_velocities = true}, {}, {.threads = threads})
        .value();
  }
};

TEST(TracksOnThreads, AreThoseOfOneWithItsErrors) {
  const Herd herd(120);
  const SampledTracks alone = herd.sampled(1), many = herd.sampled(8);
  EXPECT_EQ(alone.offsets, many.offsets);
  EXPECT_EQ(alone.times, many.times);
  EXPECT_EQ(alone.orientations, many.orientations);
  EXPECT_EQ(alone.angular_velocities, many.angular_velocities);
  ASSERT_EQ(alone.errors.size(), 17U);
  ASSERT_EQ(many.errors.size(), alone.errors.size());
  for (std::size_t i = 0; i < alone.errors.size(); ++i) EXPECT_EQ(describe(many.errors[i]), describe(alone.errors[i]));
}

}}  // namespace orispline
