// SPDX-License-Identifier: Apache-2.0
// Rows that are a set: their times neither are needed nor count.
#include <gtest/gtest.h>

#include <orispline/io/track_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::TextFile;

Expected<TrackFile> read(std::string_view content, ReadOptions options = {}, std::string_view name = "shots.csv") {
  options.count_rows = true;
  return read_track(TextFile(content, name).path(), options);
}

void expect_times(const Expected<TrackFile>& file, const std::vector<double>& times) {
  ASSERT_TRUE(file) << describe(file.error());
  const auto found = file->track.keys.times();
  EXPECT_EQ(std::vector<double>(found.begin(), found.end()), times);
  EXPECT_EQ(file->track.epoch.to_string(), "0");
}

TEST(CountedRows, NeedNoColumnOfTimes) {
  const auto file = read("qw,qx,qy,qz,px,py,pz\n1,0,0,0,1,2,3\n0.8,0.6,0,0,4,5,6\n0.6,0.8,0,0,7,8,9\n");
  expect_times(file, {0, 1, 2});
  EXPECT_EQ(file->track.keys.positions()[2], Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(file->track.lines, (std::vector<std::uint32_t>{2, 3, 4}));
}

TEST(CountedRows, DoNotCareForTheTimesThatAreThere) {
  expect_times(read("t_ms,qw,qx,qy,qz\n5,1,0,0,0\n5,0.8,0.6,0,0\n,0.6,0.8,0,0\nnoon,0,1,0,0\n"), {0, 1, 2, 3});
  expect_times(read("frame,qw,qx,qy,qz\n9,1,0,0,0\n3,0.8,0.6,0,0\n"), {0, 1});
  expect_times(read("7 0 0 0 0 0 0 1\n2 0 0 0 0.6 0 0 0.8\n", {}, "shots.tum"), {0, 1});
}

TEST(CountedRows, MayBeQuaternionsAloneInAStatedOrder) {
  const auto file = read("0.6,0,0,0.8\n0,0,0,1\n", {.order = QuaternionOrder::xyzw});
  expect_times(file, {0, 1});
  EXPECT_EQ(file->track.keys.orientations()[0].x(), 0.6);
  const auto poses = read("1,0,0,0,5,6,7\n", {.order = QuaternionOrder::wxyz});
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses->track.keys.positions()[0], Eigen::Vector3d(5, 6, 7));
  EXPECT_FALSE(read("1,0,0,0,5,6\n", {.order = QuaternionOrder::wxyz}));
}

TEST(CountedRows, AreCountedWithoutThoseThatWereDropped) {
  const auto file = read("qw,qx,qy,qz\n1,0,0,0\nnan,0,0,0\n0.6,0.8,0,0\n", {.drop_invalid = true});
  expect_times(file, {0, 1});
  EXPECT_EQ(file->repairs.invalid_dropped, 1u);
}

}}  // namespace orispline::io
