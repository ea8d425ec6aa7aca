// SPDX-License-Identifier: Apache-2.0
// Angular rates of keys: which columns are read, in which frame and unit, and what they become.
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/line_reader.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/rates_file.hpp>
#include <orispline/io/sample_writer.hpp>
#include <orispline/math/degrees.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using namespace testing_support;

KeyframeData rated_keys(const std::string& content, const ReadOptions& options) {
  auto file = read_keys(test::TextFile(content).path(), options);
  if (!file) {
    ADD_FAILURE() << describe(file.error());
    return {};
  }
  return std::move(file->data);
}

const std::string all_orders = "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n0,1,0,0,0,1,2,3,4,5,6,7,8,9\n";

TEST(Rates, AreReadUpToTheOrderThatIsAskedFor) {
  for (const int orders : {0, 1, 2, 3}) {
    const KeyframeData data = rated_keys(all_orders, {.rate_orders = orders});
    EXPECT_EQ(data.angular_velocities.size(), orders >= 1 ? 1u : 0u);
    EXPECT_EQ(data.angular_accelerations.size(), orders >= 2 ? 1u : 0u);
    EXPECT_EQ(data.angular_jerks.size(), orders >= 3 ? 1u : 0u);
  }
  const KeyframeData data = rated_keys(all_orders, {.rate_orders = 3});
  EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(data.angular_accelerations[0], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(data.angular_jerks[0], Eigen::Vector3d(7, 8, 9));
}

TEST(Rates, OfHigherOrdersMayBeMissing) {
  const KeyframeData data = rated_keys("t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,3\n", {.rate_orders = 3});
  EXPECT_EQ(data.angular_velocities.size(), 1u);
  EXPECT_TRUE(data.angular_accelerations.empty());
}

TEST(Rates, NobodyAsksForMayHoldAnything) {
  EXPECT_EQ(rated_keys("t,qw,qx,qy,qz,ax,jx\n0,1,0,0,0,none,nan\n", {}).times.size(), 1u);
}

TEST(Rates, HaveUnits) {
  const KeyframeData data = rated_keys(
      "t,qw,qx,qy,qz,wx_deg_s,wy,wz_rad_s,ax_deg_s2,ay_body_rad_s2,az_rad_s2,jx_body_deg_s3,jy_deg_s3,jz_body\n"
      "0,1,0,0,0,180,1,2,90,3,4,-180,360,5\n",
      {.rate_orders = 3});
  EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(std::numbers::pi, 1, 2));
  EXPECT_EQ(data.angular_accelerations[0], Eigen::Vector3d(std::numbers::pi / 2, 3, 4));
  EXPECT_EQ(data.angular_jerks[0], Eigen::Vector3d(-std::numbers::pi, 2 * std::numbers::pi, 5));
}

TEST(Rates, GoWithTheirKeysWhenRowsAreSortedAndDropped) {
  const KeyframeData data = rated_keys(
      "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
      "2,1,0,0,0,2,0,0,2,0,0,2,0,0\n1,1,0,0,0,1,0,0,1,0,0,1,0,0\n1,1,0,0,0,9,0,0,9,0,0,9,0,0\n"
      "3,1,0,0,0,3,0,0,nan,0,0,3,0,0\n",
      {.rate_orders = 3, .drop_duplicates = true, .drop_invalid = true, .sort = true});
  for (const auto& rates : {data.angular_velocities, data.angular_accelerations, data.angular_jerks}) {
    ASSERT_EQ(rates.size(), 2u);
    EXPECT_EQ(rates[0].x(), 1);
    EXPECT_EQ(rates[1].x(), 2);
  }
}

/// The keys of a motion with its rates, as `sample` writes them.
std::string written(const std::vector<Motion>& motions, Frame frame) {
  const test::ScratchDirectory directory;
  const std::string path = directory.file("keys.csv");
  auto writer = SampleWriter::open(path, {.derivatives = 3, .frame = frame}).value();
  for (std::size_t i = 0; i < motions.size(); ++i)
    EXPECT_TRUE(writer.write(Decimal::from_double(static_cast<double>(i)), {.motion = motions[i]}));
  EXPECT_TRUE(writer.finish());
  return test::content_of(path);
}

std::vector<Motion> random_motions(std::uint64_t seed) {
  Dice dice(seed);
  std::vector<Motion> motions;
  for (int i = 0; i < 5; ++i)
    motions.push_back({exp<double>(3.0 * dice.vector()), dice.vector(), 2.0 * dice.vector(), 3.0 * dice.vector()});
  return motions;
}

void expect_rates(const KeyframeData& data, const std::vector<Motion>& motions) {
  ASSERT_EQ(data.angular_jerks.size(), motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_TRUE(near(data.angular_velocities[i], motions[i].angular_velocity, tolerance::algebra));
    EXPECT_TRUE(near(data.angular_accelerations[i], motions[i].angular_acceleration, tolerance::algebra));
    EXPECT_TRUE(near(data.angular_jerks[i], motions[i].angular_jerk, tolerance::algebra));
  }
}

TEST(Rates, WrittenInEitherFrameAreReadBackInTheBodyFrame) {
  const auto motions = random_motions(361);
  for (const Frame frame : {Frame::body, Frame::world})
    expect_rates(rated_keys(written(motions, frame), {.rate_orders = 3, .world_rates = true}), motions);
  EXPECT_TRUE(rated_keys(written(motions, Frame::world), {.rate_orders = 3}).angular_velocities.empty());
}

TEST(Rates, InTheWorldFrameStayWhatTheyAreWhenTheFileHoldsWorldToBody) {
  const auto motions = random_motions(362);
  std::string content = written(motions, Frame::world);
  content = content.substr(0, content.find('\n') + 1);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    const auto cells = [](const auto& values) {
      std::string text;
      for (const double value : values) text += "," + Decimal::from_double(value).to_string();
      return text;
    };
    const Eigen::Quaterniond q = m.orientation.conjugate();
    content += std::to_string(i) + cells(std::array{q.w(), q.x(), q.y(), q.z()}) + cells(angular_velocity_world(m)) +
               cells(angular_acceleration_world(m)) + cells(angular_jerk_world(m)) + "\n";
  }
  expect_rates(rated_keys(content, {.conjugate = true, .rate_orders = 3, .world_rates = true}), motions);
}

TEST(Rates, OfTheBodyComeBeforeThoseOfTheWorld) {
  const KeyframeData data =
      rated_keys("t,qw,qx,qy,qz,wx,wy,wz,wx_world,wy_world,wz_world\n0,0,1,0,0,1,2,3,4,5,6\n", {.world_rates = true});
  EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(1, 2, 3));
}

TEST(Rates, OfTheBodyStayWhatTheyAreWhenTheFileHoldsWorldToBody) {
  for (const char* names : {"wx,wy,wz", "wx_rad_s,wy,wz", "wx_body,wy_body,wz_body"}) {
    const KeyframeData data = rated_keys("t,qw,qx,qy,qz," + std::string(names) + "\n0,0.6,0.8,0,0,1,2,3\n",
                                         {.conjugate = true, .world_rates = true});
    EXPECT_EQ(data.orientations[0], quaternion_wxyz(0.6, -0.8, 0.0, 0.0));
    ASSERT_EQ(data.angular_velocities.size(), 1u) << names;
    EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(1, 2, 3));
  }
}

TEST(Rates, OfAnyNameAreThoseOfTheWorldWhereTheyAreMapped) {
  const KeyframeData data =
      rated_keys("t,qw,qx,qy,qz,wx,wy,wz\n0,0,1,0,0,1,2,3\n",
                 {.columns = {{"wx_world", "wx"}, {"wy_world", "wy"}, {"wz_world", "wz"}}, .world_rates = true});
  ASSERT_EQ(data.angular_velocities.size(), 1u);
  EXPECT_TRUE(near(data.angular_velocities[0], Eigen::Vector3d(1, -2, -3), tolerance::algebra));
}

TEST(RatesOfAGyro, AreAloneWhereTheHeaderNamesNoOrientation) {
  const auto are_alone = [](const std::string& content) {
    auto input = KeyInput::open(test::TextFile(content).path());
    EXPECT_TRUE(input);
    const bool alone = holds_rates_alone(*input);
    EXPECT_EQ(std::move(*input).lines().next()->value(), content.substr(0, content.find('\n')));  // from the beginning
    return alone;
  };
  EXPECT_TRUE(are_alone("t,wx,wy,wz\n0,1,2,3\n"));
  EXPECT_TRUE(are_alone("# from a boat\nTimestamp (us),wx_deg_s,wy_deg_s,wz_deg_s,ax,ay,az\n0,1,2,3,4,5,6\n"));
  EXPECT_TRUE(are_alone("# t,wx,wy,wz\n0,1,2,3\n"));
  EXPECT_FALSE(are_alone("# t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,3\n"));
  EXPECT_FALSE(are_alone("t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,3\n"));
  EXPECT_FALSE(are_alone("t,roll_deg,pitch_deg,yaw_deg,wx,wy,wz\n0,1,0,0,1,2,3\n"));
  EXPECT_FALSE(are_alone("t,px,py,pz\n0,1,2,3\n"));
  EXPECT_FALSE(are_alone("0 1 2 3\n"));
}

TEST(RatesOfAGyro, AreNamedByACommentWhereNoRowDoes) {
  const std::string rows = "500000000,0,90,0\n1000000000,0,0,180\n";
  for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.order = QuaternionOrder::wxyz}}) {
    const auto read = read_rates(test::TextFile("#timestamp [ns],wx_deg_s,wy_deg_s,wz_deg_s\n" + rows).path(), options);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->exact_times[0].to_string(), "0.5");
    ASSERT_EQ(read->rates.size(), 2u);
    EXPECT_NEAR(read->rates[1].z() * degrees, 180.0, 1e-12);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "commented_header");
  }
  const auto eight = read_rates(test::TextFile("# a b c wx wy wz d t\n0 0 0 1 2 3 0 7\n").path());
  ASSERT_TRUE(eight) << describe(eight.error());
  EXPECT_EQ(eight->exact_times[0].to_string(), "7");  // though a file of TUM has as many numbers
  const auto refused = read_rates(test::TextFile("# from a gyro\n0,1,2,3\n").path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "found no header, wanted one that names t, wx, wy and wz");
}

TEST(RatesOfAGyro, AreMendedAsRowsAre) {
  const auto first_rates = [](const std::string& rows, const ReadOptions& options) {
    std::vector<double> rates;
    const auto read = read_rates(test::TextFile("t,wx,wy,wz\n" + rows).path(), options);
    EXPECT_TRUE(read) << describe(read.error());
    if (read)
      for (const Eigen::Vector3d& rate : read->rates) rates.push_back(rate.x());
    return rates;
  };
  using Found = std::vector<double>;
  EXPECT_EQ(first_rates("0,1,0,0\n0,9,0,0\n1,2,0,0\n", {.drop_duplicates = true}), (Found{1, 2}));
  EXPECT_EQ(first_rates("1,2,0,0\n0,1,0,0\n", {.sort = true}), (Found{1, 2}));
  const std::string twice = "0,1,0,0\n1,2,0,0\n2,3,0,0\n0.5,4,0,0\n1,5,0,0\n1.5,6,0,0\n";
  EXPECT_EQ(first_rates(twice, {.session = 2}), (Found{4, 5, 6}));
  EXPECT_EQ(first_rates("0,1,0,0\n1,2,0,0\n", {.session = 2}), (Found{1, 2}));  // it lies beside a file with several
  for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.sort = true}, ReadOptions{.session = 3}}) {
    const auto refused = read_rates(test::TextFile("t,wx,wy,wz\n" + twice).path(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(options.session ? refused.error().option : refused.error().remedy, "session");
  }
}

TEST(RatesOfAGyro, AreReadAsTheyAreWritten) {
  const RateRows rows{
      .exact_times = {Decimal::parse("1700000000.123456789").value(), Decimal::parse("1700000000.2").value()},
      .rates = {{0.1, -2.0, 3e-7}, {1.0 / 3.0, 0.0, 1e9}}};
  const test::ScratchDirectory folder;
  auto file = OutputFile::open(folder.file("gyro.csv"));
  ASSERT_TRUE(file);
  ASSERT_TRUE(write_rates(*file, rows));
  ASSERT_TRUE(file->finish());
  const auto again = read_rates(folder.file("gyro.csv"));
  ASSERT_TRUE(again) << describe(again.error());
  EXPECT_EQ(again->exact_times, rows.exact_times);
  EXPECT_EQ(again->rates, rows.rates);
}

}}  // namespace orispline::io
