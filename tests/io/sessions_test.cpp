// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>
#include <orispline/io/time_order.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/math/continuous_euler.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

std::vector<Decimal> decimals(const std::vector<double>& numbers) {
  std::vector<Decimal> result;
  for (const double number : numbers) result.push_back(Decimal::from_double(number));
  return result;
}

using Starts = std::vector<std::size_t>;

TEST(SessionStarts, AreWhereThreeRowsGoOnFromOneThatGoesBack) {
  const auto starts = [](const std::vector<double>& times) { return session_starts(decimals(times)); };
  EXPECT_EQ(starts({1, 2, 3, 4}), Starts{0});
  EXPECT_EQ(starts({1, 2, 3, 2.1, 2.2, 3.1}), Starts{0});
  EXPECT_EQ(starts({1, 2, 3, 1.1, 1.2, 1.3, 4}), (Starts{0, 3}));
  EXPECT_EQ(starts({1, 2, 3, 1.1, 1.1, 1.1, 4}), Starts{0});
  EXPECT_EQ(starts({1, 2, 3, 1.1, 1.2, 1.2, 1.3, 4, 0, 1, 2}), (Starts{0, 3, 8}));
  EXPECT_EQ(starts({5, 4, 3, 2, 1, 0}), Starts{0});
}

TEST(SessionStarts, OfShuffledRowsMayBeSortedAndBlocksMayNot) {
  const auto may_sort = [](const std::vector<Decimal>& times) {
    return may_be_sorted(times.size(), session_starts(times).size());
  };
  EXPECT_TRUE(may_sort(decimals({1, 2, 3, 2.5, 2.6, 4})));
  EXPECT_FALSE(may_sort(decimals({10, 11, 12, 13, 1, 2, 3, 4})));
  EXPECT_FALSE(may_sort(decimals({10, 11, 12, 13, 9, 10.5, 11.5, 12.5})));
  std::vector<double> shuffled;
  for (int i = 0; i < 1000; ++i) shuffled.push_back((i * 389) % 1000);
  const std::vector<Decimal> many = decimals(shuffled);
  EXPECT_TRUE(may_sort(many));
}

TEST(ZeroStamps, AreThoseThatBeginNoRecording) {
  const auto zeros = [](const std::vector<double>& times) { return zero_stamps(decimals(times)); };
  EXPECT_EQ(zeros({100, 101, 0, 102}), (std::vector<bool>{false, false, true, false}));
  EXPECT_EQ(zeros({1, 2, 0, 3}), (std::vector<bool>{false, false, false, false}));
  EXPECT_EQ(zeros({0, 1, 2}), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(zeros({0, 1, 2, 0, 3}), (std::vector<bool>{false, false, false, true, false}));
  EXPECT_EQ(zeros({0, 1, 2, 3, 0, 1, 2, 3}), std::vector<bool>(8, false));
  EXPECT_EQ(zeros({-2, -1, 0, 1}), (std::vector<bool>{false, false, false, false}));
  EXPECT_EQ(zeros({5, 6, 0, 1, 2, 3}), (std::vector<bool>{false, false, false, false, false, false}));
}

std::string rows(const std::vector<double>& times) {
  std::string text = "t,qw,qx,qy,qz\n";
  for (const double time : times) text += std::to_string(time) + ",1,0,0,0\n";
  return text;
}

TEST(Sessions, AreTracksOfAFileWhereAllAreAskedFor) {
  const TextFile file(rows({10, 11, 12, 13, 9, 10, 11, 12.5, 1, 2, 3}));
  EXPECT_EQ(sessions_in(file.path(), {}).value(), 3u);
  const auto tracks = read_tracks(file.path(), {.session = all_sessions});
  ASSERT_TRUE(tracks) << describe(tracks.error());
  ASSERT_EQ(tracks->size(), 3u);
  EXPECT_EQ((*tracks)[1].track.epoch.to_string(), "9");
  EXPECT_EQ((*tracks)[1].track.lines, (std::vector<std::uint32_t>{6, 7, 8, 9}));
  EXPECT_EQ(read_track(file.path(), {.session = 3})->track.keys.size(), 3u);
  EXPECT_EQ(read_track(file.path(), {.session = 4}).error().message, "found 4, wanted 1 to 3, which the file has");
  EXPECT_EQ(read_track(file.path(), {.session = all_sessions}).error().option, "session");
  EXPECT_EQ(sessions_in("-", {}).error().message,
            "found all with standard input, which can be read once only; wanted a file");
}

TEST(Sessions, AreNoneWhereRowsAreInDisorder) {
  EXPECT_EQ(text_of(read_keys(TextFile(rows({1, 2, 1.5})).path()).error()).find("second recording"), std::string::npos);
  const auto several = read_keys(TextFile(rows({1, 2, 1.1, 1.2, 1.3})).path());
  ASSERT_FALSE(several);
  EXPECT_EQ(several.error().remedy, "session");
  EXPECT_EQ(several.error().where.line, 4u);
}

TEST(TwoTracks, AreOnlyThoseOfRowsWithoutBoth) {
  const std::string header = "t,qw,qx,qy,qz,px,py,pz\n";
  const TextFile apart(header + "0,1,0,0,0,,,\n0.5,,,,,1,2,3\n1,0.8,0,0,0.6,,,\n1.5,,,,,4,5,6\n");
  const auto file = read_keys(apart.path());
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.times, (std::vector<double>{0, 1}));
  EXPECT_TRUE(file->data.positions.empty());
  EXPECT_EQ(file->positions_apart.times, (std::vector<double>{0.5, 1.5}));
  const TextFile both(header + "0,1,0,0,0,,,\n0.5,,,,,1,2,3\n1,0.8,0,0,0.6,1,1,1\n");
  EXPECT_EQ(text_of(read_keys(both.path()).error()),
            "keys.csv:2:6: key 0: found an empty cell, wanted a finite number (option drop_invalid)");
  EXPECT_EQ(read_keys(both.path(), {.drop_invalid = true})->repairs.invalid_dropped, 2u);
}

TEST(TypedTurns, GetRowsInBetweenWhereNoQuaternionHoldsThem) {
  const TextFile file("t,roll_deg,pitch_deg,yaw_deg\n0,0,0,0\n1,0,0,350\n2,0,0,-370\n");
  const auto keys = read_keys(file.path(), {.count_turns = true});
  ASSERT_TRUE(keys) << describe(keys.error());
  EXPECT_EQ(keys->repairs.rows_between, 5u);
  ASSERT_EQ(keys->data.times.size(), 8u);
  double turned = 0.0;
  for (std::size_t i = 1; i < keys->data.orientations.size(); ++i)
    turned += increment<double>(keys->data.orientations[i - 1], keys->data.orientations[i]).z();
  EXPECT_NEAR(turned, -370.0 / 180.0 * std::numbers::pi, 1e-12);
}

TEST(NearestRotation, IsThatOfFrobeniusNorm) {
  // A rotation times a symmetric positive matrix has that rotation as its nearest one.
  const Eigen::Matrix3d rotation = quaternion_wxyz(0.5, 0.5, -0.5, 0.5).toRotationMatrix();
  Eigen::Matrix3d stretch;
  stretch << 1.01, 0.004, 0.0, 0.004, 0.99, -0.003, 0.0, -0.003, 1.005;
  const Eigen::Matrix3d m = rotation * stretch;
  const auto nearest = nearest_rotation(OrientationNumbers(m.reshaped<Eigen::RowMajor>()));
  ASSERT_TRUE(nearest);
  EXPECT_LE((nearest->orientation.toRotationMatrix() - rotation).norm(), 1e-14);
  EXPECT_NEAR(nearest->distance, (stretch - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(ContinuousEuler, RunsThroughThePoleInEveryOrder) {
  for (const std::string_view name : {"ZYX", "XYZ", "ZXZ", "zyx", "xyz", "zxz", "YXY", "yzx"}) {
    const EulerOrder order = *euler_order_of(name);
    const ContinuousEuler turns(order);
    Eigen::Vector3d angles(0.3, 0.1, -0.2);
    for (int k = 0; k <= 100; ++k) {
      const Eigen::Vector3d wanted(0.3, 0.1 + 0.1 * k, -0.2);
      angles = turns.after(angles, quaternion_from_euler(order, wanted));
      EXPECT_LE((angles - wanted).norm(), 1e-9) << name << " " << k;
    }
  }
}

}}  // namespace orispline::io
