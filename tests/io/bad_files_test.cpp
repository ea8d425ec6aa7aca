// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using namespace std::string_literals;

/// A file that cannot be read as keyframes, and the exact error.
struct BadFile {
  std::string content;
  std::string error;
  std::string name = "keys.csv";
  ReadOptions options{};
  ErrorCode code = ErrorCode::bad_data;
};

const std::string plain_header = "t,qw,qx,qy,qz\n";
const std::string key = "0,1,0,0,0\n";

std::string not_a_number(const std::string& place, const std::string& cell, int key_index = 0) {
  return "keys.csv:" + place + ": key " + std::to_string(key_index) + ": found '" + cell +
         "', wanted a number such as -1.5e-3";
}
std::string not_finite(const std::string& place, const std::string& found) {
  return "keys.csv:" + place + ": key 0: found " + found + ", wanted a finite number (option drop_invalid)";
}

void expect_refusals(const std::vector<BadFile>& files) {
  for (const BadFile& bad : files) {
    const auto file = read_keys(test::TextFile(bad.content, bad.name).path(), bad.options);
    if (file) {
      ADD_FAILURE() << "read without an error: " << bad.content;
      continue;
    }
    EXPECT_EQ(test::text_of(file.error()), bad.error) << bad.content.substr(0, 200);
    EXPECT_EQ(file.error().code, bad.code) << bad.content.substr(0, 200);
  }
}

TEST(BadFile, WithoutKeysIsCalledEmpty) {
  const std::string empty = "keys.csv: empty: no keys";
  expect_refusals({
      {"", empty},
      {"\n\r\n \t\n", empty},
      {"# only\n# comments\n", empty},
      {"\xEF\xBB\xBF", empty},
      {plain_header, empty},
      {plain_header + "\n# 0,1,0,0,0\n", empty},
      {plain_header + "nan,1,0,0,0\n1,,0,0,0\n",
       empty + " (all 2 rows were dropped as invalid)",
       "keys.csv",
       {.drop_invalid = true}},
      {"", "keys.tum: empty: no keys", "keys.tum"},
      {"# timestamp tx ty tz qx qy qz qw\n", "keys.txt: empty: no keys", "keys.txt"},
  });
}

TEST(BadFile, ThatIsNoTextIsNamedSo) {
  expect_refusals({
      {"t,qw\0"s, "keys.csv:1: found a NUL byte, wanted a text file"},
      {plain_header + "0,1,0,0,0\n1,1,\0,0,0\n"s, "keys.csv:3: found a NUL byte, wanted a text file"},
      {"\xFF\xFEt\0,\0"s, "keys.csv:1: the file is UTF-16 text, wanted UTF-8"},
      {"t,qw,qx,qy,qz\r0,1,0,0,0\r",
       "keys.csv:1: found a carriage return within the line, wanted lines that end in LF or CRLF"},
      {std::string(std::size_t{17} << 20, 'x'), "keys.csv:1: the line is longer than 16 MiB, wanted a text file"},
      {plain_header + "\"0,1,0,0,0\n", "keys.csv:2:1: found a quote that is not closed"},
  });
}

TEST(BadFile, WithoutAUsableHeaderSaysWhatIsMissing) {
  const std::string no_header = "no header, wanted a first line such as t,qw,qx,qy,qz";
  const std::string two_ways = no_header + " or the order of the columns (option order)";
  const std::string advice = " (option columns)";
  expect_refusals({
      {key, "keys.csv:1: " + two_ways},
      {"# comment\n\n" + key, "keys.csv:3: " + two_ways},
      {"0x10,1,0,0,0\n", "keys.csv:1: " + two_ways},
      {"nan,1,0,0,0\n", "keys.csv:1: " + two_ways},
      {"0 1 2 3 0 0 0 1\n",
       "keys.csv:1: " + no_header +
           ", the format tum, of which this line may be, or the order of the columns (option order)"},
      {"0 1 2 3 0 0 1\n", "keys.txt:1: " + two_ways, "keys.txt"},
      {"t,qw,qx,qz\n" + key, "keys.csv:1: no column qy, found 't,qw,qx,qz'" + advice},
      {"sclk,q0,q1,q2,q3\n" + key, "keys.csv:1: no column t, qw, qx, qy, qz, found 'sclk,q0,q1,q2,q3'" + advice},
      {"T,W,X,Y,Z\n" + key, "keys.csv:1: no column qw, qx, qy, qz, found 'T,W,X,Y,Z'" + advice},
      {"t_min,qw,qx,qy,qz\n" + key, "keys.csv:1: no column t, found 't_min,qw,qx,qy,qz'" + advice},
      {"t:qw:qx:qy:qz\n" + key, "keys.csv:1: no column t, qw, qx, qy, qz, found 't:qw:qx:qy:qz'" + advice},
      {"hello world\n", "keys.txt:1: no column t, qw, qx, qy, qz, found 'hello,world'" + advice, "keys.txt"},
      {"t,qw,qx,qy,qz,qw\n", "keys.csv:1: the column 'qw' is there twice, wanted it once"},
      {"t,time_ns,qw,qx,qy,qz\n", "keys.csv:1: 't' and 'time_ns' could both be t, wanted one of them (option columns)"},
      {"t,qw,qx,qy,qz,px,pz\n", "keys.csv:1: found px, pz without py, wanted all three columns or none"},
      {"t,qw,qx,qy,qz,wz_rad_s\n", "keys.csv:1: found wz without wx, wy, wanted all three columns or none"},
      {"t,qw,qx,qy,qz,wx,wx_deg_s\n",
       "keys.csv:1: 'wx' and 'wx_deg_s' could both be wx, wanted one of them (option columns)"},
  });
}

TEST(BadFile, WithHalfOfItsRatesSaysWhichHalfIsMissing) {
  const ReadOptions all{.rate_orders = 3, .world_rates = true};
  const auto refusal = [&](const std::string& names, const std::string& message) {
    return BadFile{"t,qw,qx,qy,qz," + names + "\n", "keys.csv:1: " + message, "keys.csv", all};
  };
  expect_refusals({
      refusal("ax,ay,az",
              "found ax, ay, az without wx, wy, wz: angular accelerations want angular velocities beside them"),
      refusal("ax_deg_s2,ay,az,jx,jy,jz",
              "found ax_deg_s2, ay, az without wx, wy, wz: angular accelerations want "
              "angular velocities beside them"),
      refusal("wx,wy,wz,jx,jy,jz",
              "found jx, jy, jz without ax, ay, az: angular jerks want angular accelerations beside them"),
      refusal("wx,wy,wz,ax,az", "found ax, az without ay, wanted all three columns or none"),
      refusal("wx_world,wy_world", "found wx_world, wy_world without wz_world, wanted all three columns or none"),
      refusal("wx,wy,wz,ax,ax_deg_s2,ay,az",
              "'ax' and 'ax_deg_s2' could both be ax, wanted one of them (option columns)"),
      {"t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n0,1,0,0,0,1,2,3,4,five,6\n", not_a_number("2:10", "five"), "keys.csv", all},
      {"t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n0,1,0,0,0,1,2,3,4,5,\n",
       "keys.csv:2:11: key 0: found an empty cell, wanted a finite number, or none in all three cells of the rate to "
       "leave "
       "it free (option drop_invalid)",
       "keys.csv", all},
  });
}

TEST(BadFile, ThatContradictsTheOptionsIsBadUsage) {
  const auto contradiction = [](std::string content, std::string error, std::string name, ReadOptions options) {
    return BadFile{std::move(content), std::move(error), std::move(name), std::move(options), ErrorCode::bad_argument};
  };
  expect_refusals({
      contradiction(plain_header + key,
                    "[order] keys.csv:1: found a header, which states the order of the columns, wanted CSV without one",
                    "keys.csv", {.order = QuaternionOrder::wxyz}),
      contradiction("0 1 2 3 0 0 0 1\n",
                    "[order] keys.tum:1: found a TUM file, whose columns are always t tx ty tz qx qy qz qw, wanted CSV",
                    "keys.tum", {.order = QuaternionOrder::xyzw}),
      contradiction("0 1 2 3 0 0 0 1\n",
                    "[columns] keys.tum:1: found a TUM file, which has no header, wanted CSV with one", "keys.tum",
                    {.columns = {{"t", "x"}}}),
      contradiction(key, "[columns] keys.csv:1: found no header, wanted one that names the columns", "keys.csv",
                    {.columns = {{"t", "x"}}, .order = QuaternionOrder::wxyz}),
      contradiction(plain_header + key,
                    "[columns] keys.csv:1: found heading=qx, wanted a name that is read before the sign: t, qw, qx, "
                    "qy, qz, roll, "
                    "pitch, yaw, e1, e2, e3, r11, r12, r13, r21, r22, r23, r31, r32, r33, rx, ry, rz, px, py, pz, wx, "
                    "wy, wz, ax, ay, az, jx, jy, jz, wx_world, wy_world, wz_world, ax_world, ay_world, az_world, "
                    "jx_world, jy_world, jz_world, a_qw, a_qx, a_qy, a_qz, b_qw, b_qx, b_qy, b_qz, tension",
                    "keys.csv", {.columns = {{"heading", "qx"}}, .parameters = {"tension"}}),
      contradiction(plain_header + key, "[time_scale] the time scale is 0, wanted a number greater than 0", "keys.csv",
                    {.time_scale = Decimal()}),
      contradiction(plain_header + key, "[time_scale] the time scale is -0.001, wanted a number greater than 0",
                    "keys.csv", {.time_scale = -Decimal::power_of_ten(-3)}),
  });
  expect_refusals({{plain_header + key,
                    "keys.csv:1: no column 'q0_w' for qw, found 't,qw,qx,qy,qz'",
                    "keys.csv",
                    {.columns = {{"qw", "q0_w"}}}}});
}

TEST(BadFile, WithAWrongNumberOfCellsNamesTheLine) {
  const std::string widths = " columns without a header, wanted 5 (t and the quaternion) or 8 (px, py, pz after them)";
  expect_refusals({
      {plain_header + "0,1,0,0\n", "keys.csv:2: key 0: found 4 cells, wanted 5"},
      {plain_header + key + "1,1,0,0,0,7\n", "keys.csv:3: key 1: found 6 cells, wanted 5"},
      {plain_header + key + "1;1;0;0;0\n", "keys.csv:3: key 1: found 1 cell, wanted 5"},
      {plain_header + key + "1,1,0,0,0,,7\n", "keys.csv:3: key 1: found 7 cells, wanted 5"},
      {plain_header + key + "1,1,0\n",
       "keys.csv:3: key 1: found 3 cells, wanted 5",
       "keys.csv",
       {.drop_invalid = true}},
      {"0 1 2 3 0 0 0\n", "keys.tum:1: key 0: found 7 cells, wanted 8", "keys.tum"},
      {"0,1,2,3,0,0,0,1\n", "keys.tum:1: key 0: found 1 cell, wanted 8", "keys.tum"},
      {"0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1 9\n", "keys.txt:2: key 1: found 9 cells, wanted 8", "keys.txt"},
      {"0,1,0,0\n", "keys.csv:1: found 4" + widths, "keys.csv", {.order = QuaternionOrder::wxyz}},
      {"0,1,0,0,0,1,2\n", "keys.csv:1: found 7" + widths, "keys.csv", {.order = QuaternionOrder::xyzw}},
  });
}

TEST(BadFile, WithACellThatIsNoNumberNamesLineAndColumn) {
  expect_refusals({
      {plain_header + "0,one,0,0,0\n", not_a_number("2:2", "one")},
      {plain_header + key + "# 3\n\n1,1,0,0,abc\n", not_a_number("5:5", "abc", 1)},
      {plain_header + "0,0x10,0,0,0\n", not_a_number("2:2", "0x10")},
      {"t;qw;qx;qy;qz\n0;1,0;0;0;0\n", not_a_number("2:2", "1,0")},
      {plain_header + "0,1.0.0,0,0,0\n", not_a_number("2:2", "1.0.0")},
      {plain_header + "0,1 2,0,0,0\n", not_a_number("2:2", "1 2")},
      {plain_header + "0,1,--0,0,0\n", not_a_number("2:3", "--0")},
      {plain_header + "0,1,0,1e,0\n", not_a_number("2:4", "1e")},
      {plain_header + "0,1,0,0,NA\n", not_a_number("2:5", "NA")},
      {plain_header + "12:30:01,1,0,0,0\n", not_a_number("2:1", "12:30:01")},
      {plain_header + "2024-05-32T12:30:01Z,1,0,0,0\n",
       "keys.csv:2:1: key 0: found '2024-05-32T12:30:01Z', wanted a time of ISO 8601 such as 2024-02-29T12:30:00.25Z"},
      {plain_header + "0,1,0,0," + std::string(1 << 20, '#') + "\n", not_a_number("2:5", std::string(40, '#') + "...")},
      {plain_header + "0,1e999,0,0,0\n", "keys.csv:2:2: key 0: found '1e999', wanted a number below 1.8e308 in size"},
      {plain_header + "1e999,1,0,0,0\n",
       "keys.csv:2:1: key 0: found '1e999', wanted a number between 1e-150 and 1e150 in size"},
      {plain_header + "0.12345678901234567890123456789012345678,1,0,0,0\n",
       "keys.csv:2:1: key 0: found '0.12345678901234567890123456789012345678', wanted at most 37 significant digits"},
      {"timestamp tx ty tz qx qy qz qw\n0 1 2 3 0 0 0 1\n",
       "keys.tum:1:1: key 0: found 'timestamp', wanted a number such as -1.5e-3", "keys.tum"},
      {"t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,1,up,3\n", not_a_number("2:7", "up")},
      {"t,qw,qx,qy,qz,tension\n0,1,0,0,0,tight\n",
       not_a_number("2:6", "tight"),
       "keys.csv",
       {.parameters = {"tension"}}},
      {plain_header + "x,nan,0,0,0\n", not_a_number("2:1", "x"), "keys.csv", {.drop_invalid = true}},
  });
}

TEST(BadFile, WithACellThatIsNotFiniteNamesTheRepair) {
  expect_refusals({
      {plain_header + "0,nan,0,0,0\n", not_finite("2:2", "'nan'")},
      {plain_header + "0,1,NaN,0,0\n", not_finite("2:3", "'NaN'")},
      {plain_header + "-inf,1,0,0,0\n", not_finite("2:1", "'-inf'")},
      {plain_header + "0,1,0,0,\n", not_finite("2:5", "an empty cell")},
      {plain_header + ",1,0,0,0\n", not_finite("2:1", "an empty cell")},
      {plain_header + ",,,,\n", not_finite("2:1", "an empty cell")},
      {"t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,infinity\n", not_finite("2:8", "'infinity'")},
      {"t,qw,qx,qy,qz,px_km,py,pz\n0,1,0,0,0,1e308,0,0\n", not_finite("2:6", "'1e308'")},
  });
}

TEST(BadFile, WhoseTimesDoNotIncreaseNamesThemAsTheyStandThere) {
  const std::string duplicate = ", wanted increasing times (option drop_duplicates)";
  const std::string decrease = ", wanted increasing times (option sort)";
  expect_refusals({
      {plain_header + "1311868229.5760,1,0,0,0\n1311868229.5760,1,0,0,0\n",
       "keys.csv:3: key 1: duplicate time 1311868229.5760, as in line 2" + duplicate},
      {plain_header + "0,1,0,0,0\n\n# four\n-0.0,1,0,0,0\n",
       "keys.csv:5: key 1: duplicate time -0.0, as in line 2" + duplicate},
      {plain_header + "1700000000.25,1,0,0,0\n1699999999.75,1,0,0,0\n",
       "keys.csv:3: key 1: time 1699999999.75 comes after 1700000000.25" + decrease},
      {"t_ns,qw,qx,qy,qz\n5,1,0,0,0\n6,1,0,0,0\n4,1,0,0,0\n", "keys.csv:4: key 2: time 4 comes after 6" + decrease},
      {"2 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1\n", "keys.txt:2: key 1: time 1 comes after 2" + decrease, "keys.txt"},
      {plain_header + "0,1,0,0,0\n1700000000.1,1,0,0,0\n1700000000.1000000001,1,0,0,0\n",
       "keys.csv:4: key 2: time 1700000000.1000000001 is too near to 1700000000.1 to be told apart in double "
       "precision, wanted keys farther apart"},
  });
}

TEST(BadFile, ThatCannotBeReadIsBadAccess) {
  const test::ScratchDirectory directory;
  std::filesystem::create_directory(directory.file("folder.csv"));
  for (const auto& [name, reason] : {std::pair{"absent.csv", "cannot open: No such file or directory"},
                                     {"folder.csv", "cannot read: Is a directory"}}) {
    const auto file = read_keys(directory.file(name));
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::bad_access);
    EXPECT_EQ(test::text_of(file.error()), std::string(name) + ": " + reason);
  }
}

}}  // namespace orispline::io
