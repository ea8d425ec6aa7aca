// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using namespace std::string_literals;
using test::content_of;
using test::ScratchDirectory;
using test::text_of;
using test::TextFile;

const std::string written_header =
    "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n";
const std::string dataset_header =
    "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], "
    "v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1]\n";
const std::string two_rows =
    "1403636580838555648,4.5,-1.75,0.75,0.5,-0.5,0.5,-0.5\n"
    "1403636580843555328,4.25,-1.5,0.5,0.5,-0.5,-0.5,-0.5\n";

Expected<KeyFile> euroc_file(const std::string& content, const ReadOptions& options = {},
                             std::string_view name = "data.csv") {
  return read_keys(TextFile(content, name).path(), options);
}

void expect_the_two_keys(const Expected<KeyFile>& file) {
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->format, &euroc_format);
  EXPECT_EQ(file->epoch.to_string(), "1403636580.838555648");
  EXPECT_EQ(file->data.times, (std::vector<double>{0.0, 0.00499968}));
  EXPECT_EQ(file->data.orientations[0], quaternion_wxyz(0.5, -0.5, 0.5, -0.5));
  EXPECT_EQ(file->data.positions[0], Eigen::Vector3d(4.5, -1.75, 0.75));
  EXPECT_TRUE(file->data.angular_velocities.empty());
}

TEST(EuRoC, IsKnownByItsHeader) {
  for (const std::string& header :
       {written_header, dataset_header.substr(0, dataset_header.find(", v_RS")) + "\n",
        "# timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\r\n"s,
        "# made by a tracker\n\n#timestamp [ns],p_RS_R_x,p_RS_R_y,p_RS_R_z,q_RS_w,q_RS_x,q_RS_y,q_RS_z\n"s,
        "timestamp_ns,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"s})
    for (const char* name : {"data.csv", "data.txt"}) expect_the_two_keys(euroc_file(header + two_rows, {}, name));
}

TEST(EuRoC, IsReadWithoutAHeaderWhereItIsAskedFor) {
  expect_the_two_keys(euroc_file(two_rows, {.format = &euroc_format}));
  expect_the_two_keys(euroc_file("# notes\n" + two_rows, {.format = &euroc_format}, "data.tum"));
}

TEST(EuRoC, MayHaveMoreColumns) {
  std::string wide;
  for (const char c : two_rows) wide += c == '\n' ? ",0.5,nan,x,1.0,2.0\n" : std::string(1, c);
  const auto file = euroc_file(dataset_header + wide);
  expect_the_two_keys(file);
  EXPECT_EQ(file->ignored_columns, std::vector<std::string>{"columns 9 to 13"});
}

TEST(EuRoC, IsNotGuessedFromOtherHeaders) {
  const std::string advice = "no header, wanted a first line such as t,qw,qx,qy,qz";
  for (const char* header :
       {"", "#timestamp [us],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n",
        "#timestamp [ns],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m]\n"}) {
    const std::string line = *header ? "2" : "1";
    EXPECT_EQ(text_of(euroc_file(header + two_rows).error()),
              "data.csv:" + line + ": " + advice +
                  ", the format euroc, of which this line may be, or the order of the columns (option order)");
  }
  EXPECT_EQ(text_of(euroc_file("1,2,3,4,5,6,7,8\n").error()),
            "data.csv:1: " + advice + " or the order of the columns (option order)");
}

TEST(EuRoC, HeaderIsOverruledByTheCaller) {
  const auto mapped = euroc_file(
      "timestamp_ns,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n" + two_rows,
      {.columns = {{"qw", "q_RS_w []"}, {"qx", "q_RS_x []"}, {"qy", "q_RS_y []"}, {"qz", "q_RS_z []"}}});
  ASSERT_TRUE(mapped) << describe(mapped.error());
  EXPECT_EQ(mapped->format, &csv_format);
  EXPECT_TRUE(mapped->data.positions.empty());
}

TEST(EuRoC, RefusesWhatIsNotItsKind) {
  const auto refusal = [](const std::string& content, ReadOptions options = {}) {
    options.format = &euroc_format;
    return text_of(euroc_file(content, options).error());
  };
  EXPECT_EQ(refusal("1403636580.5,1,2,3,1,0,0,0\n"),
            "data.csv:1:1: key 0: found '1403636580.5', wanted whole nanoseconds");
  EXPECT_EQ(refusal("1,2,3,4,1,0,0\n"),
            "data.csv:1: found 7 columns, wanted at least 8 (time, position, quaternion w,x,y,z)");
  EXPECT_EQ(refusal("1 2 3 4 1 0 0 0\n"),
            "data.csv:1: found 1 column, wanted at least 8 (time, position, quaternion w,x,y,z)");
  EXPECT_EQ(refusal("1,2,3,4,1,0,0,0,9\n2,2,3,4,1,0,0,0\n"), "data.csv:2: key 1: found 8 cells, wanted 9");
  EXPECT_EQ(refusal(two_rows, {.order = QuaternionOrder::wxyz}),
            "[order] data.csv:1: found an EuRoC file, whose columns are always time, position, quaternion w,x,y,z, "
            "wanted CSV");
  EXPECT_EQ(refusal(two_rows, {.columns = {{"t", "stamp"}}}),
            "[columns] data.csv:1: found an EuRoC file, whose columns are fixed, wanted CSV");
  EXPECT_EQ(refusal(two_rows, {.orientation = {.euler = EulerOrder{}}}),
            "[euler] data.csv:1: found an EuRoC file, whose columns are fixed, wanted CSV");
}

TEST(EuRoC, TimesAreScaledByTheCaller) {
  const auto file =
      euroc_file("1.5,1,2,3,1,0,0,0\n", {.format = &euroc_format, .time_scale = Decimal::power_of_ten(0)});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->epoch.to_string(), "1.5");
}

std::string written(const std::vector<std::string>& times) {
  const ScratchDirectory directory;
  const std::string path = directory.file("data.csv");
  auto writer = SampleWriter::open(path, {.format = &euroc_format});
  Sample sample{.motion = {.orientation = quaternion_wxyz(0.5, -0.5, 0.5, -0.5)}};
  sample.linear_motion.position = {1, 2, 3};
  for (const std::string& time : times)
    if (auto done = writer->write(Decimal::parse(time).value(), sample); !done) return done.error().message;
  EXPECT_TRUE(writer->finish());
  return content_of(path);
}

TEST(EuRoC, IsWrittenWithTheHeaderOfTheDataset) {
  EXPECT_EQ(written({"1403636580.838555648"}),
            "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"
            "1403636580838555648,1,2,3,0.5,-0.5,0.5,-0.5\n");
}

TEST(EuRoC, TimesAreRoundedToTheNearestNanosecond) {
  const std::string text = written({"-2.0000000005", "0.0000000014999", "0.0000000015", "1700000000.1234567894"});
  EXPECT_NE(text.find("\n-2000000001,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n2,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1700000000123456789,"), std::string::npos) << text;
}

TEST(EuRoC, RefusesTwoSamplesOnOneNanosecond) {
  EXPECT_EQ(written({"1.0000000001", "1.0000000002"}),
            "two samples fall on the nanosecond 1000000000, wanted times that differ in EuRoC");
}

}}  // namespace orispline::io
