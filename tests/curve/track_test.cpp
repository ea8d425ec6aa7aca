// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/track.hpp>

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/tracks.hpp>

// What belongs to keys goes along when some of them are picked, moved in time or given rates.

namespace orispline { namespace {

using Indices = std::array<std::size_t, 3>;

/// Five keys of a file that begins at 1e9 s, with a tension each.
Track some_track() {
  KeyframeData data;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto t = static_cast<double>(i);
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(2.0 * t, 0.0, 0.0)));  // whose signs turn over
    data.positions.emplace_back(t, 0.0, 0.0);
    data.angular_velocities.emplace_back(2.0, 0.0, 0.0);
  }
  Track track = Keyframes::make(std::move(data)).value();
  track.name = "keys.csv";
  track.epoch = Decimal::parse("1000000000.25").value();
  track.lines = {2, 3, 5, 6, 7};
  track.settings["tension"] = {0.0, 0.1, 0.2, 0.3, 0.4};
  return track;
}

TEST(Track, KeepsWhatBelongsToTheKeysThatArePicked) {
  const Track track = some_track(), picked = track.at(Indices{0, 2, 4});
  EXPECT_EQ(picked.name, "keys.csv");
  EXPECT_EQ(picked.lines, (std::vector<std::uint32_t>{2, 5, 7}));
  EXPECT_EQ(picked.settings.at("tension"), (std::vector{0.0, 0.2, 0.4}));
  EXPECT_EQ(picked.keys.positions()[2].x(), 4.0);
  EXPECT_EQ(picked.keys.angular_velocities().size(), 3u);
  EXPECT_EQ(picked.time_of(1).to_string(), "1000000002.25");
}

TEST(Track, AlignsTheSignsOfTheKeysThatArePicked) {
  const Track picked = some_track().at(Indices{0, 2, 4});
  const auto q = picked.keys.orientations();
  for (std::size_t i = 1; i < q.size(); ++i) EXPECT_GE(q[i].dot(q[i - 1]), 0.0);
}

TEST(Track, NamesTheLineOfAKey) {
  EXPECT_EQ(describe(some_track().located({ErrorCode::bad_data, "what", {.key = 2}})), "keys.csv:5: key 2: what");
}

TEST(Track, KeepsAllButItsTimesWhenItIsMoved) {
  Track track = some_track();
  track.exact_times = std::vector(5, Decimal());
  const Track later = track.with_times({0, 2, 4, 6, 8}).value();
  EXPECT_EQ(later.settings, track.settings);
  EXPECT_TRUE(later.exact_times.empty());
  EXPECT_EQ(later.time_of(4).to_string(), "1000000008.25");
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(later.keys.orientations()[i].coeffs(), track.keys.orientations()[i].coeffs());
}

TEST(Keyframes, RefusesTimesThatAreNoTimesOfKeys) {
  const Keyframes keys = some_track().keys;
  const auto refused = [&](std::vector<double> times) { return keys.with_times(std::move(times)).error(); };
  EXPECT_EQ(refused({0, 1, 2, 3}).message, "found 5 orientations for 4 times, wanted one per key");
  EXPECT_EQ(refused({0, 1, 1, 2, 3}).where.key, 2u);
  EXPECT_EQ(refused({0, 1, 2, 3, std::numeric_limits<double>::infinity()}).where.key, 4u);
}

TEST(Keyframes, TakesRatesOfItsOwnNumberOnly) {
  const Keyframes keys = some_track().keys;
  const std::vector<Eigen::Vector3d> rates(5, Eigen::Vector3d::UnitY());
  const Keyframes with = keys.with_rates(rates, rates).value();
  EXPECT_EQ(with.angular_accelerations()[4], Eigen::Vector3d::UnitY());
  EXPECT_TRUE(keys.with_rates({}).value().angular_velocities().empty());
  EXPECT_FALSE(keys.with_rates({rates[0]}));
  std::vector<Eigen::Vector3d> broken = rates;
  broken[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(keys.with_rates(broken).error().where.key, 3u);
}

TEST(Method, PicksTheSettingsOfKeysAndKeepsThoseOfGhosts) {
  const std::array<std::size_t, 2> indices{1, 3};
  const Method each{"quintic", {.parameters = {{"tension", {0, 1, 2, 3}}}}};
  EXPECT_EQ(each.at(indices, 4).options.parameters.at("tension"), (std::vector{1.0, 3.0}));
  const Method ghosts{"quintic", {.parameters = {{"tension", {-1, 0, 1, 2, 3, 4}}}}};
  EXPECT_EQ(ghosts.at(indices, 4).options.parameters.at("tension"), (std::vector{-1.0, 1.0, 3.0, 4.0}));
  const Method one{"quintic", {.parameters = {{"tension", {0.5}}}}};
  EXPECT_EQ(one.at(indices, 4).options.parameters.at("tension"), std::vector{0.5});
}

TEST(Method, TakesSettingsOfItsOwnFromATrackWhereItIsSilent) {
  const Track track = some_track();
  const FamilyInfo &quintic = **find_family("quintic"), &slerp = **find_family("slerp");
  EXPECT_EQ(completed("quintic", quintic, track).options.parameters.at("tension"), track.settings.at("tension"));
  const Method stated{"quintic", {.parameters = {{"tension", {0.7}}}}};
  EXPECT_EQ(completed(stated, quintic, track).options.parameters.at("tension"), std::vector{0.7});
  EXPECT_TRUE(completed("slerp", slerp, track).options.parameters.empty());
}

}}  // namespace orispline
