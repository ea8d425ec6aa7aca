// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/exact_number.hpp"
#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::decimal;
using test::text_of;
using test::TextFile;

KeyFile csv_file(std::string_view content, const ReadOptions& options = {}, std::string_view name = "keys.csv") {
  auto file = read_keys(TextFile(content, name).path(), options);
  if (!file) {
    ADD_FAILURE() << describe(file.error());
    return {};
  }
  return std::move(*file);
}

const Eigen::Quaterniond half_turn_z = quaternion_wxyz(0.0, 0.0, 0.0, 1.0);
const Eigen::Quaterniond tilted = quaternion_wxyz(0.5, -0.5, 0.5, -0.5);

TEST(Csv, ReadsTheColumnsThatTheHeaderNames) {
  const KeyFile file = csv_file(
      "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz\n"
      "10,1,0,0,0,1,2,3,0.1,0.2,0.3\n"
      "10.5,0.5,-0.5,0.5,-0.5,4,5,6,-0.1,-0.2,-0.3\n");

  EXPECT_EQ(file.format, &csv_format);
  EXPECT_EQ(file.epoch.to_string(), "10");
  EXPECT_EQ(file.data.times, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(file.data.orientations[1], tilted);
  EXPECT_EQ(file.data.positions[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(file.data.angular_velocities[1], Eigen::Vector3d(-0.1, -0.2, -0.3));
  EXPECT_EQ(file.lines, (std::vector<std::uint32_t>{2, 3}));
}

TEST(Csv, ReadsColumnsInAnyOrderAndIgnoresOthers) {
  const KeyFile file =
      csv_file("note,qz,qy,t,mode,qx,qw,wx_world,wy_world,wz_world\nup,-0.5,0.5,3,x y,-0.5,0.5,7,8,9\n");

  EXPECT_EQ(file.data.orientations[0], tilted);
  EXPECT_TRUE(file.data.positions.empty());
  EXPECT_TRUE(file.data.angular_velocities.empty());
}

TEST(Csv, KnowsEveryDelimiter) {
  for (const char* content :
       {"t,qw,qx,qy,qz\n1,.5,-.5,.5,-.5\n", "t;qw;qx;qy;qz\n1;.5;-.5;.5;-.5\n",
        "t\tqw\tqx\tqy\tqz\n1\t.5\t-.5\t.5\t-.5\n", "t qw qx qy qz\n1 .5 -.5 .5 -.5\n",
        "  t  qw qx   qy qz \n 1   .5\t -.5 .5    -.5 \n", "t, qw, qx, qy, qz\n1,\t.5, -.5 , .5, -.5\n"}) {
    const KeyFile file = csv_file(content);
    ASSERT_EQ(file.data.orientations.size(), 1u) << content;
    EXPECT_EQ(file.data.orientations[0], tilted) << content;
  }
}

TEST(Csv, ToleratesHowProgramsWriteIt) {
  const char* contents[] = {
      "t,qw,qx,qy,qz\r\n1,.5,-.5,.5,-.5\r\n",        // CRLF
      "\xEF\xBB\xBFt,qw,qx,qy,qz\n1,.5,-.5,.5,-.5",  // byte order mark, no last LF
      "# made by hand\n\n  # twice\nt,qw,qx,qy,qz\n#1,1,0,0,0\n\n1,.5,-.5,.5,-.5\n\n# end\n",  // comments, blank lines
      "\"t\",\"qw\",\"qx\",\"qy\",\"qz\"\n\"1\",\".5\",\"-.5\",\".5\",\"-.5\"\n",              // quotes
      "t,qw,qx,qy,qz,\n1,.5,-.5,.5,-.5,\n",                          // a comma at the end of all lines
      "t,qw,qx,qy,qz\n1,.5,-.5,.5,-.5,,\n",                          // of the rows
      "t,qw,qx,qy,qz,\n1,.5,-.5,.5,-.5\n",                           // of the header
      ",t,qw,qx,qy,qz\n0,1,.5,-.5,.5,-.5\n",                         // an unnamed index column
      "note;t;qw;qx;qy;qz\n\"a;b\";1;.5;-.5;.5;-.5\n",               // a delimiter in quotes
      "t,qw,qx,qy,qz,\"a;b\tc\"\n1,.5,-.5,.5,-.5,0\n",               // others in those of a name
      "note,t,qw,qx,qy,qz\n\"say \"\"a, b\"\"\",1,.5,-.5,.5,-.5\n",  // quotes in quotes
      "note,t,qw,qx,qy,qz\n\"\"\"\",1,.5,-.5,.5,-.5\n",
      "size in \",t,qw,qx,qy,qz\n2,1,.5,-.5,.5,-.5\n",
      "a 5\"\" wheel,t,qw,qx,qy,qz\n2,1,.5,-.5,.5,-.5\n",
      "a 5\" wheel,t,qw,qx,qy,qz\n2\",1,.5,-.5,.5,-.5\n",  // quotes within a cell
  };
  for (const char* content : contents) {
    const KeyFile file = csv_file(content);
    ASSERT_EQ(file.data.orientations.size(), 1u) << content;
    EXPECT_EQ(file.data.orientations[0], tilted) << content;
    EXPECT_EQ(file.epoch.to_string(), "1") << content;
  }
}

TEST(Csv, CountsCommentsAndBlankLinesInLineNumbers) {
  const KeyFile file = csv_file("# one\n\nt,qw,qx,qy,qz\n0,1,0,0,0\n# five\n1,1,0,0,0\n");
  EXPECT_EQ(file.lines, (std::vector<std::uint32_t>{4, 6}));
}

TEST(Csv, UnderstandsUnitsOfTime) {
  const std::pair<const char*, const char*> cases[] = {
      {"t", "1500"},      {"time", "1500"}, {"timestamp", "1500"}, {"t_s", "1500"},
      {"time_s", "1500"}, {"t_ms", "1.5"},  {"time_us", "0.0015"}, {"timestamp_ns", "0.0000015"}};
  for (const auto& [name, seconds] : cases) {
    const KeyFile file = csv_file(std::string(name) + ",qw,qx,qy,qz\n1500,1,0,0,0\n");
    EXPECT_EQ(file.epoch.to_string(), seconds) << name;
  }
}

TEST(Csv, UnderstandsUnitsOfPositionsAndRates) {
  const KeyFile file = csv_file(
      "t,qw,qx,qy,qz,px_mm,py_cm,pz_km,wx_body_rad_s,wy_deg_s,wz_body_deg_s\n"
      "0,1,0,0,0,1234.5,25,0.5,0.25,180,-90\n");
  EXPECT_EQ(file.data.positions[0], Eigen::Vector3d(1.2345, 0.25, 500.0));
  EXPECT_EQ(file.data.angular_velocities[0], Eigen::Vector3d(0.25, std::numbers::pi, -std::numbers::pi / 2));
}

TEST(Csv, MapsOtherNames) {
  const KeyFile file = csv_file("stamp_ns,q0_w,q1,q2,q3,alt_mm,x,y,stiffness\n2000000000,.5,-.5,.5,-.5,3000,1,2,0.75\n",
                                {.columns = {{"t", "stamp_ns"},
                                             {"qw", "q0_w"},
                                             {"qx", "q1"},
                                             {"qy", "q2"},
                                             {"qz", "q3"},
                                             {"px", "x"},
                                             {"py", "y"},
                                             {"pz", "alt_mm"},
                                             {"tension", "stiffness"}},
                                 .parameters = {"tension"}});
  EXPECT_EQ(file.epoch.to_string(), "2");
  EXPECT_EQ(file.data.orientations[0], tilted);
  EXPECT_EQ(file.data.positions[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(file.parameters.at("tension"), std::vector<double>{0.75});
}

TEST(Csv, PrefersAMappedNameToTheCanonicalOne) {
  const KeyFile file = csv_file("t,qw,qx,qy,qz,device_t\n5,1,0,0,0,7\n", {.columns = {{"t", "device_t"}}});
  EXPECT_EQ(file.epoch.to_string(), "7");
}

TEST(Csv, ReadsOnlyTheParametersThatAreAskedFor) {
  const std::string content = "t,qw,qx,qy,qz,tension,tension2,bias\n0,1,0,0,0,0.5,0.25,9\n1,1,0,0,0,-0.5,1e-3,9\n";
  const KeyFile file = csv_file(content, {.parameters = {"tension", "tension2", "tension3"}});
  EXPECT_EQ(file.parameters.size(), 2u);
  EXPECT_EQ(file.parameters.at("tension"), (std::vector<double>{0.5, -0.5}));
  EXPECT_EQ(file.parameters.at("tension2"), (std::vector<double>{0.25, 1e-3}));
  EXPECT_TRUE(csv_file(content).parameters.empty());
}

TEST(Csv, WithoutAHeaderTakesTheOrderThatIsGiven) {
  const KeyFile wxyz = csv_file("0,0,0,0,1\n1,1,0,0,0\n", {.order = QuaternionOrder::wxyz});
  EXPECT_EQ(wxyz.data.orientations[0], half_turn_z);
  EXPECT_EQ(wxyz.lines, (std::vector<std::uint32_t>{1, 2}));

  const KeyFile xyzw = csv_file("0 0 0 1 0 7 8 9\n", {.order = QuaternionOrder::xyzw}, "keys.txt");
  EXPECT_EQ(xyzw.format, &csv_format);
  EXPECT_EQ(csv_file("0 0 0 1 0 7 8 9\n", {.order = QuaternionOrder::xyzw, .keep_table = true}, "keys.txt").table.names,
            (std::vector<std::string>{"t", "qx", "qy", "qz", "qw", "px", "py", "pz"}));
  EXPECT_EQ(csv_file("0 0 0 0 1\n", {.order = QuaternionOrder::wxyz, .keep_table = true}, "keys.txt").table.names,
            (std::vector<std::string>{"t", "qw", "qx", "qy", "qz"}));
  EXPECT_EQ(xyzw.data.orientations[0], half_turn_z);
  EXPECT_EQ(xyzw.data.positions[0], Eigen::Vector3d(7, 8, 9));
}

TEST(Csv, ScalesTimesInTheDecimalDomain) {
  const KeyFile file = csv_file("t,qw,qx,qy,qz\n218174919753.0,1,0,0,0\n218174919776.55994,1,0,0,0\n",
                                {.time_scale = decimal("0.00390625")});
  EXPECT_EQ(file.epoch.to_string(), "852245780.28515625");
  EXPECT_EQ(file.data.times[1], 0.092031015625);  // 23.55994 / 256
}

TEST(Csv, ScaleOverridesTheUnitOfTheName) {
  EXPECT_EQ(csv_file("t_ns,qw,qx,qy,qz\n8,1,0,0,0\n", {.time_scale = decimal("0.25")}).epoch.to_string(), "2");
}

TEST(Csv, KeepsThePrecisionOfTimes) {
  const KeyFile nanoseconds = csv_file("t_ns,qw,qx,qy,qz\n1700000000123456789,1,0,0,0\n1700000000123456790,1,0,0,0\n");
  EXPECT_EQ(nanoseconds.epoch.to_string(), "1700000000.123456789");
  EXPECT_EQ(nanoseconds.data.times[1], 1e-9);

  const KeyFile seconds =
      csv_file("t,qw,qx,qy,qz\n1.7e9,1,0,0,0\n1700000000.000000001,1,0,0,0\n+1700000000.1,1,0,0,0\n");
  EXPECT_EQ(seconds.epoch.to_string(), "1700000000");
  EXPECT_EQ(seconds.data.times, (std::vector<double>{0.0, 1e-9, 0.1}));

  const KeyFile negative = csv_file("t,qw,qx,qy,qz\n-2.5,1,0,0,0\n-1e-1,1,0,0,0\n3,1,0,0,0\n");
  EXPECT_EQ(negative.epoch.to_string(), "-2.5");
  EXPECT_EQ(negative.data.times, (std::vector<double>{0.0, 2.4, 5.5}));
}

TEST(Csv, ConjugatesOrientationsAndNothingElse) {
  const KeyFile file = csv_file("t,qw,qx,qy,qz,px,py,pz\n0,.5,-.5,.5,-.5,1,2,3\n", {.conjugate = true});
  EXPECT_EQ(file.data.orientations[0], quaternion_wxyz(0.5, 0.5, -0.5, 0.5));
  EXPECT_EQ(file.data.positions[0], Eigen::Vector3d(1, 2, 3));
}

TEST(Csv, TakesRatesOfConjugateFilesAsThoseOfTheBody) {
  const auto rates = [](std::string_view names, ReadOptions options) {
    options.conjugate = true;
    return csv_file("t,qw,qx,qy,qz," + std::string(names) + "\n0,1,0,0,0,1,2,3\n", options).data.angular_velocities;
  };
  EXPECT_EQ(rates("wx,wy,wz", {}).size(), 1u);
  EXPECT_EQ(rates("wx_rad_s,wy_rad_s,wz_rad_s", {}).size(), 1u);
  EXPECT_EQ(rates("wx_body,wy_body,wz_body", {}).size(), 1u);
  EXPECT_EQ(rates("wx_body_rad_s,wy_body_rad_s,wz_body_rad_s", {}).size(), 1u);
  EXPECT_EQ(rates("a,b,c", {.columns = {{"wx", "a"}, {"wy", "b"}, {"wz", "c"}}}).size(), 1u);
}

TEST(Csv, FormatFollowsOptionThenExtensionThenContent) {
  const std::string eight = "1 2 3 4 0 0 0 1\n", named = "t,qw,qx,qy,qz\n0,1,0,0,0\n";
  EXPECT_EQ(csv_file(eight, {}, "keys.tum").format, &tum_format);
  EXPECT_EQ(csv_file(eight, {}, "keys.TUM").format, &tum_format);
  EXPECT_EQ(csv_file(eight, {}, "keys.txt").format, &tum_format);
  EXPECT_EQ(csv_file(eight, {.format = &tum_format}, "keys.csv").format, &tum_format);
  EXPECT_EQ(csv_file(named, {}, "keys.txt").format, &csv_format);
  EXPECT_EQ(csv_file(named, {.format = &csv_format}, "keys.tum").format, &csv_format);
}

TEST(Csv, KeepsExactTimesOnRequest) {
  const std::string content = "t_ns,qw,qx,qy,qz\n98765432109876543210,1,0,0,0\n198765432109876543211,1,0,0,0\n";
  const KeyFile file = csv_file(content, {.keep_exact_times = true});
  ASSERT_EQ(file.exact_times.size(), 2u);
  EXPECT_EQ(file.exact_times[0].to_string(), "98765432109.87654321");
  EXPECT_EQ(file.exact_times[1].to_string(), "198765432109.876543211");  // 21 digits: no double holds the difference
  EXPECT_TRUE(csv_file(content).exact_times.empty());

  const KeyFile sorted = csv_file("t,qw,qx,qy,qz\n2,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n",
                                  {.drop_duplicates = true, .sort = true, .keep_exact_times = true});
  ASSERT_EQ(sorted.exact_times.size(), 2u);
  EXPECT_EQ(sorted.exact_times[0].to_string(), "1");
}

TEST(Csv, NamesTheColumnsThatItIgnores) {
  const KeyFile file = csv_file(",note,t,qw,qx,qy,qz,wx_world,tension,px,py,pz\n0,a,0,1,0,0,0,1,2,3,4,5\n");
  EXPECT_EQ(file.ignored_columns, (std::vector<std::string>{"note", "wx_world", "tension"}));
  EXPECT_TRUE(csv_file("t,qw,qx,qy,qz\n0,1,0,0,0\n").ignored_columns.empty());
}

TEST(Csv, PlacesTheErrorsOfKeys) {
  const auto file = csv_file("# one\nt,qw,qx,qy,qz\n0,1,0,0,0\n\n1,2,0,0,0\n", {.norms = Norms::as_they_are});
  const auto keys = Keyframes::make(file.data);
  ASSERT_FALSE(keys);
  EXPECT_EQ(text_of(located(file, keys.error())),
            "keys.csv:5: key 1: the quaternion has norm 2, wanted 1 within 0.001");
  EXPECT_EQ(text_of(located(file, {ErrorCode::bad_argument, "too few", {}})), "keys.csv: too few");
}

}}  // namespace orispline::io
