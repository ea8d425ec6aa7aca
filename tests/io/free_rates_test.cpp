// SPDX-License-Identifier: Apache-2.0
// Rates that some keys of a file leave free: how they are read, refused and written.
#include <string>

#include <gtest/gtest.h>

#include <orispline/curve/keyframe.hpp>
#include <orispline/io/track_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

const std::string rates_header = "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n";

Expected<KeyFile> free_rates_file(const std::string& rows, const ReadOptions& options = {.rate_orders = 3}) {
  return read_keys(test::TextFile(rates_header + rows).path(), options);
}

std::string free_rates_refusal(const std::string& content,
                               const ReadOptions& options = {.rate_orders = 3, .world_rates = true}) {
  const auto file = read_keys(test::TextFile(content).path(), options);
  return file ? "" : file.error().message;
}

TEST(FreeRates, AreThoseWhoseThreeCellsAreEmptyOrNaN) {
  const auto file =
      free_rates_file("0,1,0,0,0,1,2,3,,,\n1,1,0,0,0,,,,4,5,6\n2,1,0,0,0,nan,NaN,nan,7,8,9\n3,1,0,0,0,1,1,1,2,2,2\n");
  ASSERT_TRUE(file) << describe(file.error());
  const auto &w = file->data.angular_velocities, &a = file->data.angular_accelerations;
  ASSERT_EQ(w.size(), 4u);
  EXPECT_EQ(w[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(is_free(a[0]) && is_free(w[1]) && is_free(w[2]));
  EXPECT_EQ(a[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(file->repairs.rates_left_free, 3u);
  EXPECT_EQ(file->repairs.invalid_dropped, 0u);
}

TEST(FreeRates, AreFreeInTheWorldFrameToo) {
  const auto file =
      read_keys(test::TextFile("t,qw,qx,qy,qz,wx_world,wy_world,wz_world\n0,0,1,0,0,,,\n1,0,1,0,0,1,2,3\n").path(),
                {.world_rates = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_TRUE(is_free(file->data.angular_velocities[0]));
  EXPECT_EQ(file->data.angular_velocities[1], Eigen::Vector3d(1, -2, -3));
}

TEST(FreeRates, LackAllComponentsOrNone) {
  const std::string remedy = ", wanted a finite number, or none in all three cells of the rate to leave it free";
  EXPECT_EQ(free_rates_refusal(rates_header + "0,1,0,0,0,1,,3,1,1,1\n"), "found an empty cell" + remedy);
  EXPECT_EQ(free_rates_refusal(rates_header + "0,1,0,0,0,1,1,1,nan,nan,1\n"), "found 'nan'" + remedy);
  EXPECT_EQ(free_rates_refusal(rates_header + "0,1,0,0,0,inf,inf,inf,1,1,1\n"), "found 'inf', wanted a finite number");
  const auto dropped =
      free_rates_file("0,1,0,0,0,1,,3,1,1,1\n1,1,0,0,0,1,2,3,1,1,1\n", {.rate_orders = 2, .drop_invalid = true});
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->data.times.size(), 1u);
  EXPECT_EQ(dropped->repairs.invalid_dropped, 1u);
}

TEST(FreeRates, AreNotFiniteWhereAllAreWanted) {
  EXPECT_TRUE(
      free_rates_refusal(rates_header + "0,1,0,0,0,,,,1,1,1\n", {.rate_orders = 1, .free_rates = FreeRates::refused})
          .starts_with("found an empty cell, wanted a finite number"));
}

TEST(FreeRates, DoNotTurnAJerkOfTheWorld) {
  const std::string names = "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx_world,jy_world,jz_world\n";
  EXPECT_EQ(free_rates_refusal(names + "0,1,0,0,0,1,2,3,,,,1,1,1\n"),
            "found an angular jerk in the frame of the world without the angular velocity and acceleration of its key, "
            "wanted them as well, or the jerk left free");
  EXPECT_EQ(free_rates_refusal(names + "0,1,0,0,0,1,2,3,,,,,,\n"), "");
}

TEST(FreeRates, AreWrittenSoThatTheyAreReadAgain) {
  Track track(Keyframes::make({.times = {0.0, 1.0, 2.0},
                               .orientations = std::vector<Eigen::Quaterniond>(3, Eigen::Quaterniond::Identity()),
                               .angular_velocities = {{1, 2, 3}, free_rate(), {4, 5, 6}},
                               .angular_accelerations = {free_rate(), {7, 8, 9}, free_rate()}})
                  .value());
  const test::ScratchDirectory directory;
  const std::string path = directory.file("keys.csv");
  auto out = OutputFile::open(path).value();
  ASSERT_TRUE(write_tracks(out, std::span(&track, 1), {.derivatives = 3}));
  ASSERT_TRUE(out.finish());
  const auto again = read_keys(path, {.rate_orders = 3});
  ASSERT_TRUE(again) << describe(again.error());
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& w = again->data.angular_velocities[i];
    EXPECT_EQ(is_free(w), i == 1);
    EXPECT_TRUE(i == 1 || w == track.keys.angular_velocities()[i]);
    EXPECT_EQ(is_free(again->data.angular_accelerations[i]), i != 1);
  }
}

}}  // namespace orispline::io
