// SPDX-License-Identifier: Apache-2.0
// Rows as programs write them: names in a comment, units that the caller states, jumps, leap seconds.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/file_option.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/math/degrees.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

Expected<KeyFile> keys_in(const std::string& text, const StatedOptions& stated = {}) {
  Reading reading;
  return take_options(reading, stated).and_then([&] { return read_keys(TextFile(text).path(), reading.options); });
}

TEST(CommentedHeader, NamesTheColumnsWhereNoRowDoes) {
  for (const char* header :
       {"# t,qw,qx,qy,qz\n", "#t, qw, qx, qy, qz\n", "# made by a program\n# t;qw;qx;qy;qz\n", "# t qw qx qy qz\n",
        "#timestamp [s],qw,qx,qy,qz\n", "# t,qw,qx,qy,qz\n# orispline: method=slerp\n",
        "# orispline: method=slerp\n# t,qw,qx,qy,qz\n"}) {
    const auto file = keys_in(std::string(header) + "0,1,0,0,0\n0.5,0.8,0,0,0.6\n");
    ASSERT_TRUE(file) << header << describe(file.error());
    EXPECT_EQ(file->data.times, (std::vector<double>{0, 0.5})) << header;
    EXPECT_EQ(file->data.orientations[1].z(), 0.6) << header;
    ASSERT_EQ(file->warnings.size(), 1u) << header;
    EXPECT_EQ(file->warnings[0].code, "commented_header") << header;
  }
  const auto scaled =
      keys_in("#timestamp [ns],qw,qx,qy,qz\n1650458715596950054,1,0,0,0\n1650458715696950054,1,0,0,0\n");
  ASSERT_TRUE(scaled) << describe(scaled.error());
  EXPECT_EQ(scaled->epoch.to_string(), "1650458715.596950054");
  EXPECT_EQ(scaled->data.times[1], 0.1);
}

TEST(CommentedHeader, IsNotWhatASentenceOrAnOrderSays) {
  for (const char* comment : {"", "# seconds and a quaternion then\n", "# t,qw,qx,qy\n", "# 0,1,0,0,0\n", "#\n"})
    EXPECT_EQ(text_of(keys_in(std::string(comment) + "0,1,0,0,0\n1,1,0,0,0\n").error()).find("no header, wanted"),
              text_of(keys_in("0,1,0,0,0\n1,1,0,0,0\n").error()).find("no header, wanted"))
        << comment;
  const auto ordered = keys_in("# t,qw,qx,qy,qz\n0,0,0,0,1\n1,0,0,0,1\n", {{"order", "xyzw"}});
  ASSERT_TRUE(ordered) << describe(ordered.error());
  EXPECT_EQ(ordered->data.orientations[0].w(), 1.0);
}

TEST(CommentedHeader, WithoutAUnitOfAnglesAsksForIt) {
  const std::string rows = "#HEADER: \"t\", \"roll\", \"pitch\", \"yaw\"\n0.5, 0, 0, 350\n1, 0, 0, 354\n";
  EXPECT_EQ(keys_in(rows).error().remedy, "angle_unit");
  const auto file = keys_in(rows, {{"angle_unit", "deg"}});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_NEAR(angular_distance(file->data.orientations[0], file->data.orientations[1]) * degrees, 4.0, 1e-9);
}

TEST(Columns, StateAUnitBehindTheNameThatIsRead) {
  const std::string rows = "t,qw,qx,qy,qz,wx,wy,wz,x,y,z,r,p,h\n0,1,0,0,0,180,90,0,1000,2,3,0,0,90\n";
  const auto rates = keys_in(rows, {{"columns", "wx_deg_s=wx,wy_deg_s=wy,wz_deg_s=wz,px_mm=x,py_mm=y,pz_mm=z"}});
  ASSERT_TRUE(rates) << describe(rates.error());
  EXPECT_NEAR(rates->data.angular_velocities[0].x() * degrees, 180.0, 1e-12);
  EXPECT_NEAR(rates->data.positions[0].x(), 1.0, 1e-15);
  const auto angles = keys_in(rows, {{"columns", "roll_deg=r,pitch_deg=p,yaw_deg=h"}, {"input_orientation", "euler"}});
  ASSERT_TRUE(angles) << describe(angles.error());
  EXPECT_NEAR(angles->data.orientations[0].z(), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(keys_in(rows, {{"columns", "wx_furlong=wx"}}).error().option, "columns");
}

TEST(TwoOrientationsAtOneInstant, AreAJumpOrWrittenTwice) {
  const std::string before = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n";
  EXPECT_EQ(keys_in(before + "1,1,0,0,0\n2,1,0,0,0\n").error().remedy, "drop_duplicates");
  const std::string jump = before + "1,0.8,0,0,0.6\n2,0.8,0,0,0.6\n";
  for (const StatedOptions& stated : {StatedOptions{}, StatedOptions{{"sort", ""}}}) {
    const auto file = keys_in(jump, stated);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().remedy, "jumps");
    EXPECT_NE(file.error().message.find("the orientation jumps there by 73.7°"), std::string::npos)
        << file.error().message;
  }
  const auto near = keys_in(before + "1,0.9998,0,0,0.02\n2,1,0,0,0\n");
  EXPECT_EQ(near.error().remedy, "drop_duplicates");
  EXPECT_NE(near.error().message.find("; the row is turned by 2.29° from that one"), std::string::npos)
      << near.error().message;
  EXPECT_EQ(sessions_in(TextFile(jump).path(), {}).value(), 2u);
  EXPECT_EQ(keys_in(jump, {{"session", "1"}})->lines, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(keys_in(jump, {{"session", "2"}})->lines, (std::vector<std::uint32_t>{4, 5}));
  EXPECT_EQ(keys_in(jump, {{"drop_duplicates", ""}})->lines, (std::vector<std::uint32_t>{2, 3, 5}));
}

TEST(TwoOrientationsAtOneInstant, AreBothKeysWhereTheyMayJump) {
  const std::string header = "t,qw,qx,qy,qz,wx,wy,wz\n", before = "0,1,0,0,0,0,0,0\n1,1,0,0,0,0,0,0\n";
  const std::string reset = "1.0,0.8,0,0,0.6,0,0,0\n", kick = "1,1,0,0,0,0,0,2\n", after = "2,0.8,0,0,0.6,0,0,0\n";
  for (const std::string& second : {reset, kick})
    for (const StatedOptions& stated :
         {StatedOptions{{"jumps", ""}}, StatedOptions{{"jumps", ""}, {"sort", ""}},
          StatedOptions{{"jumps", ""}, {"session", "1"}}, StatedOptions{{"jumps", ""}, {"drop_duplicates", ""}}}) {
      const auto file = keys_in(header + before + second + after, stated);
      ASSERT_TRUE(file) << describe(file.error());
      EXPECT_EQ(file->data.times, (std::vector<double>{0, 1, 1, 2}));
      EXPECT_TRUE(file->data.jumps && file->recipe.jumps);
    }
  const auto stated = keys_in("# orispline: jumps\n" + header + before + reset + after);
  ASSERT_TRUE(stated) << describe(stated.error());
  EXPECT_TRUE(stated->data.jumps && stated->recipe.jumps);
}

TEST(TwoOrientationsAtOneInstant, AreNoJumpWhereTheyAreAlikeOrOneOfThree) {
  const std::string before = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n", twice = before + "1,-1,0,0,0\n2,1,0,0,0\n";
  EXPECT_EQ(keys_in(twice, {{"jumps", ""}}).error().remedy, "drop_duplicates");
  EXPECT_EQ(keys_in(twice, {{"jumps", ""}, {"drop_duplicates", ""}})->lines, (std::vector<std::uint32_t>{2, 3, 5}));
  const auto third = keys_in(before + "1,0.8,0,0,0.6\n1,0,0,0,1\n2,1,0,0,0\n", {{"jumps", ""}});
  ASSERT_FALSE(third);
  EXPECT_NE(third.error().message.find("a third row has this time, and a jump has two"), std::string::npos)
      << third.error().message;
}

TEST(TwoOrientationsAtOneInstant, AreNoJumpWhereStampsAreCoarserThanTheRows) {
  std::string rows = "t,qw,qx,qy,qz\n";
  for (int row = 0; row < 12; ++row)
    rows += std::to_string(row / 4) + "," + std::to_string(std::cos(0.1 * row)) + ",0,0," +
            std::to_string(std::sin(0.1 * row)) + "\n";
  EXPECT_EQ(keys_in(rows).error().remedy, "columns");
}

TEST(LeapSecond, IsNamedWhereItsTimesComeTwice) {
  const auto error_of = [](const std::string& last) {
    return keys_in("t,qw,qx,qy,qz\n2016-12-31T23:59:60Z,1,0,0,0\n2016-12-31T23:59:60.5Z,1,0,0,0\n" + last + "\n")
        .error();
  };
  for (const char* last :
       {"2017-01-01T00:00:00Z,1,0,0,0", "2017-01-01T00:00:00.5Z,1,0,0,0", "2017-01-01T00:00:00.5Z,0.8,0,0,0.6"}) {
    const Error error = error_of(last);
    EXPECT_NE(error.message.find("the leap second 23:59:60 is not counted, so that its times come twice; leave out its "
                                 "rows, or give times that have no leap seconds"),
              std::string::npos)
        << error.message;
    EXPECT_EQ(error.remedy, "") << "neither order nor a second recording is meant";
  }
  const auto other = keys_in("t,qw,qx,qy,qz\n2017-01-01T00:00:00Z,1,0,0,0\n2017-01-01T00:00:00Z,1,0,0,0\n");
  EXPECT_EQ(other.error().message.find("leap"), std::string::npos);
}

}}  // namespace orispline::io
