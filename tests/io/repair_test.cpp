// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

/// Keys at x = 1, 2, … of a half turn each, so that rows can be told apart by their position.
Expected<KeyFile> repaired(const std::vector<std::string>& times, const ReadOptions& options) {
  std::string content = "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,tension\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    content += times[i] + ",0,1,0,0," + n + ",0,0," + n + ",0,0," + n + "\n";
  }
  ReadOptions with_tension = options;
  with_tension.parameters = {"tension"};
  return read_keys(TextFile(content).path(), with_tension);
}

/// Numbers of the rows that became keys, in order; also checks that all columns of a row stayed together.
std::vector<double> rows_of(const KeyFile& file) {
  std::vector<double> rows;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    rows.push_back(file.data.positions[i].x());
    EXPECT_EQ(file.data.angular_velocities[i].x(), rows[i]);
    EXPECT_EQ(file.parameters.at("tension")[i], rows[i]);
    EXPECT_EQ(file.lines[i], rows[i] + 1.0);
  }
  EXPECT_EQ(file.data.orientations.size(), rows.size());
  EXPECT_EQ(file.data.times.size(), rows.size());
  return rows;
}

using Rows = std::vector<double>;

TEST(DropDuplicates, KeepsTheFirstOfEqualTimes) {
  const auto file = repaired({"1", "1.0", "2", "20e-1", "2", "3"}, {.drop_duplicates = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(rows_of(*file), (Rows{1, 3, 6}));
  EXPECT_EQ(file->repairs.duplicates_dropped, 3u);
}

TEST(DropDuplicates, ComparesTimesBeyondTheDigitsOfADouble) {
  const auto file = repaired({"1700000000.1234567890", "1700000000.1234567891"}, {.drop_duplicates = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.times, (std::vector<double>{0.0, 1e-10}));
  EXPECT_EQ(file->repairs.duplicates_dropped, 0u);
}

TEST(DropDuplicates, LeavesDecreasingTimesAnError) {
  const auto file = repaired({"1", "2", "1"}, {.drop_duplicates = true});
  ASSERT_FALSE(file);
  EXPECT_EQ(text_of(file.error()), "keys.csv:4: key 2: time 1 comes after 2, wanted increasing times (option sort)");
}

TEST(DropInvalid, DropsRowsWithACellThatIsEmptyOrNotFinite) {
  const auto file = read_keys(TextFile("t,qw,qx,qy,qz,note\n"
                                       "0,1,0,0,0,nan\n"
                                       "1,nan,nan,nan,nan,\n"
                                       "nan,1,0,0,0,\n"
                                       "2,1,0,,0,\n"
                                       "inf,1,0,0,0,\n"
                                       "3,1,0,0,-Infinity,\n"
                                       "4,1,0,0,0,\n")
                                  .path(),
                              {.drop_invalid = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->lines, (std::vector<std::uint32_t>{2, 8}));
  EXPECT_EQ(file->data.times, (std::vector<double>{0.0, 4.0}));
  EXPECT_EQ(file->repairs.invalid_dropped, 5u);
}

TEST(DropInvalid, TakesTheFirstValidRowAsTheEpoch) {
  const auto file = repaired({"nan", "5", "6"}, {.drop_invalid = true});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->epoch.to_string(), "5");
}

TEST(DropInvalid, LeavesGarbageAnError) {
  const auto file = repaired({"1", "two"}, {.drop_invalid = true});
  ASSERT_FALSE(file);
  EXPECT_EQ(text_of(file.error()), "keys.csv:3:1: key 1: found 'two', wanted a number such as -1.5e-3");
}

TEST(Sort, OrdersTheRowsByTime) {
  const auto file = repaired({"3", "1", "2", "-4", "5"}, {.sort = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(rows_of(*file), (Rows{4, 2, 3, 1, 5}));
  EXPECT_EQ(file->epoch.to_string(), "-4");
  EXPECT_EQ(file->data.times, (std::vector<double>{0, 5, 6, 7, 9}));
}

TEST(Sort, CountsTheRowsThatStoodAfterALaterTime) {
  EXPECT_EQ(repaired({"3", "1", "2", "-4", "5"}, {.sort = true})->repairs.rows_moved, 3u);
  EXPECT_EQ(repaired({"1", "2", "3"}, {.sort = true})->repairs.rows_moved, 0u);
}

TEST(Sort, ReportsEqualTimesWithBothLines) {
  const auto file = repaired({"3.50", "1", "3.5"}, {.sort = true});
  ASSERT_FALSE(file);
  EXPECT_EQ(text_of(file.error()),
            "keys.csv:4: key 2: duplicate time 3.5, as in line 2, wanted increasing times (option drop_duplicates)");
}

TEST(Sort, KeepsTheFirstOfEqualTimesInTheFile) {
  const auto file = repaired({"3", "1", "3", "1", "2"}, {.drop_duplicates = true, .sort = true});
  ASSERT_TRUE(file);
  EXPECT_EQ(rows_of(*file), (Rows{2, 5, 1}));
  EXPECT_EQ(file->repairs.duplicates_dropped, 2u);
}

TEST(Repairs, WorkTogether) {
  const auto file =
      repaired({"2", "nan", "1", "2", "0.5"}, {.drop_duplicates = true, .drop_invalid = true, .sort = true});
  ASSERT_TRUE(file);
  EXPECT_EQ(rows_of(*file), (Rows{5, 3, 1}));
  EXPECT_EQ(file->repairs.duplicates_dropped, 1u);
  EXPECT_EQ(file->repairs.invalid_dropped, 1u);
  EXPECT_EQ(file->repairs.rows_moved, 2u);
}

TEST(Repairs, TouchNothingInAGoodFile) {
  const auto file = repaired({"1", "2", "3"}, {.drop_duplicates = true, .drop_invalid = true, .sort = true});
  ASSERT_TRUE(file);
  EXPECT_EQ(rows_of(*file), (Rows{1, 2, 3}));
  EXPECT_EQ(file->repairs.duplicates_dropped + file->repairs.invalid_dropped + file->repairs.rows_moved, 0u);
}

}}  // namespace orispline::io
