// SPDX-License-Identifier: Apache-2.0
// Many tracks in one call: each has the samples of its own curve, whatever the threads and the other tracks.
#include <orispline/online/sample_tracks.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <online/track_stream.hpp>
#include <support/follower.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr double table_step = 0.05;  // [s]
constexpr WantedSamples everything{.angular_velocities = true,
                                   .angular_accelerations = true,
                                   .angular_jerks = true,
                                   .positions = true,
                                   .velocities = true,
                                   .accelerations = true};

struct Tracks {
  std::vector<KeyframeData> data;
  std::vector<std::int64_t> offsets{0};
  std::vector<double> times;
  std::array<std::vector<double>, 4> orientations;
  std::array<std::vector<double>, 3> positions;

  explicit Tracks(const std::vector<std::size_t>& sizes) {
    for (const std::size_t size : sizes) add(raw_walk(841 + data.size(), size));
  }
  void add(const KeyframeData& track) {
    data.push_back(track);
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      times.push_back(track.times[i]);
      for (std::size_t c = 0; c < 4; ++c)
        orientations[c].push_back(track.orientations[i].coeffs()[static_cast<Eigen::Index>(c)]);
      for (std::size_t c = 0; c < 3; ++c) positions[c].push_back(track.positions[i][static_cast<Eigen::Index>(c)]);
    }
    offsets.push_back(static_cast<std::int64_t>(times.size()));
  }
  [[nodiscard]] TrackColumns columns() const {
    return {.offsets = offsets,
            .times = times,
            .orientations = {orientations[0], orientations[1], orientations[2], orientations[3]},
            .positions = {positions[0], positions[1], positions[2]}};
  }
};

/// Whether the columns from a sample on are those rows.
template <std::size_t N>
bool same(const std::array<std::vector<double>, N>& columns, std::size_t first, const std::vector<double>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (columns[i % N][first + i / N] != rows[i]) return false;
  return true;
}

TEST(SampleTracks, GivesEachTrackTheSamplesOfItsOwnCurve) {
  const Tracks tracks({30, 1, 7, 200, 2});
  for (const std::string_view method : {"auto", "rotation-spline"})
    for (const unsigned threads : {1u, 3u}) {
      const auto table =
          sample_tracks(method, tracks.columns(), {.step = table_step}, everything, {}, {.threads = threads});
      ASSERT_TRUE(table) << describe(table.error());
      EXPECT_TRUE(table->errors.empty());
      ASSERT_EQ(table->offsets.size(), 6u);
      for (std::size_t i = 0; i < tracks.data.size(); ++i) {
        const auto curve = make_pose_curve(method, keyframes(tracks.data[i], Signs::shortest)).value();
        const TrackSamples wanted = of_whole(curve, tracks.data[i].times.front(), table_step);
        const auto first = static_cast<std::size_t>(table->offsets[i]);
        ASSERT_EQ(static_cast<std::size_t>(table->offsets[i + 1]) - first, wanted.size());
        EXPECT_TRUE(std::ranges::equal(std::span(table->times).subspan(first, wanted.size()), wanted.times));
        EXPECT_TRUE(same(table->orientations, first, wanted.orientations));
        EXPECT_TRUE(same(table->angular_velocities, first, wanted.angular_velocities));
        EXPECT_TRUE(same(table->angular_accelerations, first, wanted.angular_accelerations));
        EXPECT_TRUE(same(table->angular_jerks, first, wanted.angular_jerks));
        EXPECT_TRUE(same(table->positions, first, wanted.positions));
        EXPECT_TRUE(same(table->velocities, first, wanted.velocities));
        EXPECT_TRUE(same(table->accelerations, first, wanted.accelerations));
      }
    }
}

TEST(SampleTracks, RefusesAKeyThatTooManySamplesLieBefore) {
  Tracks tracks({20, 20, 20});
  const std::string last =
      "key 19: found a request for 5e+13 samples since the key before, wanted 1e+09 at most: check "
      "the rate and the unit of the times, or set `gap`";
  tracks.times[39] = 1e12;
  for (const TrackGrid& grid : {TrackGrid{.step = 0.02}, TrackGrid{.step = 1.0, .parts = 50.0, .start = 0.0},
                                TrackGrid{.request = SampleGrid::Request{.spacing = SampleRate{50.0}}}}) {
    const auto table = sample_tracks("auto", tracks.columns(), grid).value();
    ASSERT_EQ(table.errors.size(), 1u);
    EXPECT_EQ(table.errors[0].where.curve, 1u);
    EXPECT_EQ(table.errors[0].where.key, 19u);
    EXPECT_EQ("key 19: " + table.errors[0].message, last);
    EXPECT_EQ(table.offsets[1], table.offsets[2]);
    EXPECT_LT(table.offsets[2], table.offsets[3]);
    EXPECT_TRUE(sample_tracks("auto", tracks.columns(), grid, {}, {.gap = 1e6})->errors.empty());
  }
  tracks.times[39] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sample_tracks("auto", tracks.columns(), {.step = 0.02})->errors.at(0).message,
            "time is inf, wanted a finite number");
}

TEST(SampleTracks, SaysOfWhichTracksTheKeysAreBadAndSamplesTheOthers) {
  Tracks tracks({20, 20, 0, 20});
  const auto good = sample_tracks("auto", tracks.columns(), {.step = table_step}).value();
  ASSERT_EQ(good.errors.size(), 1u);
  EXPECT_EQ(describe(good.errors[0]), describe({ErrorCode::bad_data, "empty: no keys", {.curve = 2}}));
  tracks.times[25] = tracks.times[24];
  const auto table = sample_tracks("auto", tracks.columns(), {.step = table_step}).value();
  ASSERT_EQ(table.errors.size(), 2u);
  EXPECT_EQ(table.errors[0].where.curve, 1u);
  EXPECT_EQ(table.errors[0].where.key, 5u);
  EXPECT_EQ(table.offsets[1], table.offsets[2]);
  EXPECT_EQ(table.offsets[4] - table.offsets[3], good.offsets[4] - good.offsets[3]);
  EXPECT_TRUE(
      std::equal(table.orientations[2].rbegin(), table.orientations[2].rbegin() + 20, good.orientations[2].rbegin()));
  EXPECT_TRUE(table.angular_velocities[0].empty());
}

TEST(TrackBatch, CountsTheSamplesAndFillsColumnsOfTheCaller) {
  const Tracks tracks({30, 0, 700, 2});
  const SampledTracks wanted =
      sample_tracks("auto", tracks.columns(), {.step = table_step}, {.positions = true, .velocities = true}).value();
  TrackBatch batch = TrackBatch::make("auto", tracks.columns(), {.step = table_step}, {}, {.threads = 2}).value();
  EXPECT_TRUE(std::ranges::equal(batch.offsets(), wanted.offsets));
  ASSERT_EQ(batch.errors().size(), 1u);
  EXPECT_EQ(batch.errors()[0].where.curve, 1u);
  const std::size_t size = batch.size();
  ASSERT_GT(size, 2048u);
  std::vector<std::vector<double>> own(10, std::vector<double>(size));
  const TrackSampleColumns columns{.orientations = {own[0], own[1], own[2], own[3]},
                                   .positions = {own[4], own[5], own[6]},
                                   .velocities = {own[7], own[8], own[9]}};
  TrackSampleColumns bad = columns;
  bad.orientations[2] = bad.orientations[2].first(size - 1);
  EXPECT_EQ(batch.take(bad).error().message,
            "found a column for " + std::to_string(size - 1) + " samples, wanted one for " + std::to_string(size));
  std::vector<double> more(size + 1);
  EXPECT_EQ(batch.take({.orientations = {more, more, more, more}}).error().message,
            "found columns for " + std::to_string(size + 1) + " samples, wanted " + std::to_string(size) + " at most");
  bad = columns;
  bad.positions[1] = {};
  EXPECT_EQ(batch.take(bad).error().message, "found a column for 0 samples, wanted one for " + std::to_string(size));
  ASSERT_TRUE(batch.take(columns, {.threads = 3}));
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(own[c], wanted.orientations[c]);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(own[4 + c], wanted.positions[c]);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(own[7 + c], wanted.velocities[c]);
  EXPECT_EQ(batch.left(), 0u);
  EXPECT_FALSE(batch.take(columns));
}

TEST(TrackBatch, GivesItsSamplesInPartsAcrossTheEndsOfTracks) {
  const Tracks tracks({30, 0, 700, 2, 1, 90});
  const SampledTracks wanted =
      sample_tracks("auto", tracks.columns(), {.step = table_step}, {.angular_velocities = true}).value();
  for (const std::size_t part : {std::size_t{1}, std::size_t{37}, std::size_t{2500}}) {
    TrackBatch batch = TrackBatch::make("auto", tracks.columns(), {.step = table_step}).value();
    const std::size_t size = batch.size();
    std::vector<std::vector<double>> own(8, std::vector<double>(size));
    for (std::size_t first = 0; first < size; first += part) {
      const std::size_t count = std::min(part, size - first);
      const auto room = [&](std::size_t i) { return std::span(own[i]).subspan(first, count); };
      ASSERT_EQ(batch.left(), size - first);
      ASSERT_TRUE(batch.take({.times = room(0),
                              .orientations = {room(1), room(2), room(3), room(4)},
                              .angular_velocities = {room(5), room(6), room(7)}},
                             {.threads = 1 + static_cast<unsigned>(first % 2)}));
    }
    EXPECT_EQ(own[0], wanted.times);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(own[1 + c], wanted.orientations[c]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(own[5 + c], wanted.angular_velocities[c]);
  }
}

TEST(TrackBatch, GivesTheSamplesOfOneTrackByColumns) {
  const Tracks tracks({2000});
  const SampledTracks wanted =
      sample_tracks("auto", tracks.columns(), {.step = table_step}, {.velocities = true}).value();
  for (const unsigned threads : {1u, 3u}) {
    TrackSampler sampler = TrackSampler::make("auto", {.step = table_step}).value();
    ASSERT_TRUE(sampler.append(tracks.data[0]));
    ASSERT_TRUE(sampler.finish());
    const std::size_t size = wanted.times.size();
    std::vector<std::vector<double>> own(8, std::vector<double>(size));
    const auto columns = [&](std::size_t first, std::size_t count) {
      const auto room = [&](std::size_t i) { return std::span(own[i]).subspan(first, count); };
      return TrackSampleColumns{.times = room(0),
                                .orientations = {room(1), room(2), room(3), room(4)},
                                .velocities = {room(5), room(6), room(7)}};
    };
    ASSERT_TRUE(take_columns(sampler, columns(0, 5), {.threads = threads}));
    EXPECT_FALSE(take_columns(sampler, columns(0, size), {.threads = threads}));
    ASSERT_TRUE(take_columns(sampler, columns(5, size - 5), {.threads = threads}));
    EXPECT_EQ(own[0], wanted.times);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(own[1 + c], wanted.orientations[c]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(own[5 + c], wanted.velocities[c]);
  }
}

TEST(SampleTracks, ShowsTheShareOfTheTracksAndStops) {
  const Tracks tracks({30, 5, 70, 2, 40});
  for (const unsigned threads : {1u, 3u})
    testing_support::expect_to_be_followed_and_stopped(
        [&](const Progress& progress) {
          return sample_tracks("auto", tracks.columns(), {.step = table_step}, {}, {}, {.threads = threads}, progress);
        },
        threads - 1);
}

TEST(SampleTracks, RefusesColumnsThatDoNotBelongTogether) {
  const Tracks tracks({20, 20});
  const auto refusal = [](const TrackColumns& columns, const WantedSamples& wanted = {}) {
    const auto table = sample_tracks("auto", columns, {.step = table_step}, wanted);
    return table ? "taken" : table.error().message;
  };
  TrackColumns columns = tracks.columns();
  columns.orientations[3] = columns.orientations[3].first(39);
  EXPECT_EQ(refusal(columns), "found 39 orientations for 40 times, wanted as many");
  columns = tracks.columns();
  columns.positions[1] = {};
  EXPECT_EQ(refusal(columns), "found 0 positions for 40 times, wanted as many or none");
  columns.positions = {};
  EXPECT_EQ(refusal(columns, {.velocities = true}), "positions are wanted, and the keys have none");
  const std::vector<std::int64_t> no_keys{0, 0};  // and so no samples
  columns.offsets = no_keys;
  EXPECT_EQ(refusal(columns, {.velocities = true}), "positions are wanted, and the keys have none");
  for (const std::vector<std::int64_t>& offsets : {std::vector<std::int64_t>{}, {0, 41}, {-1, 40}, {0, 30, 20}}) {
    columns = tracks.columns();
    columns.offsets = offsets;
    EXPECT_EQ(refusal(columns), "the offsets do not rise from 0 on to 40, the number of keys, at most");
  }
}

}}  // namespace orispline
